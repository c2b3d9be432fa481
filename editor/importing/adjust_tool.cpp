// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/adjust_tool.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>
#include <QMenu>

#include "editor/document/message_words.h"
#include "editor/importing/findings_painting.h"
#include "editor/importing/mark_corrections.h"

namespace detent::editor {
namespace {

using Kind = PageHandle::Kind;

QString tr(const char* text) { return QCoreApplication::translate("detent::editor::AdjustTool", text); }

double distanceTo(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

double distanceToSegment(QPointF p, QPointF a, QPointF b) {
  const QPointF d = b - a;
  const double length2 = d.x() * d.x() + d.y() * d.y();
  const double t =
      length2 > 0 ? std::clamp(((p.x() - a.x()) * d.x() + (p.y() - a.y()) * d.y()) / length2, 0.0, 1.0) : 0;
  return distanceTo(p, a + t * d);
}

/// Returns true if the edges are parallel to the page's, so that a drag keeps the frame a rectangle.
bool isUpright(const FrameCorners& c) {
  const double size = std::hypot(c[2].x - c[0].x, c[2].y - c[0].y), within = 1e-3 * size;
  const auto straight = [within](importer::Point a, importer::Point b) {
    return std::min(std::abs(a.x - b.x), std::abs(a.y - b.y)) <= within;
  };
  return straight(c[0], c[1]) && straight(c[1], c[2]) && straight(c[2], c[3]) && straight(c[3], c[0]);
}

void shift(importer::Point& p, importer::Point by) { p = {p.x + by.x, p.y + by.y}; }

/// Moves corner i: alone, or with the two edges that meet in it, so that an upright rectangle stays one.
void moveCorner(FrameCorners& c, std::size_t i, importer::Point by, bool keepsRectangle) {
  const bool rectangle = keepsRectangle && isUpright(c);
  const std::size_t next = (i + 1) % 4, before = (i + 3) % 4;
  const bool nextIsLevel = std::abs(c[next].y - c[i].y) < std::abs(c[next].x - c[i].x);
  shift(c[i], by);
  if (!rectangle) return;
  shift(c[next], nextIsLevel ? importer::Point{0, by.y} : importer::Point{by.x, 0});
  shift(c[before], nextIsLevel ? importer::Point{by.x, 0} : importer::Point{0, by.y});
}

void moveEdge(FrameCorners& c, std::size_t i, importer::Point by) {
  const std::size_t next = (i + 1) % 4;
  const bool level = std::abs(c[next].y - c[i].y) < std::abs(c[next].x - c[i].x);
  const importer::Point across = level ? importer::Point{0, by.y} : importer::Point{by.x, 0};
  shift(c[i], across);
  shift(c[next], across);
}

// Forbidden changes are reported and not kept.
void takeMarks(PageView& view, const Corrections& next, const QString& label) {
  const ImportGraph* graph = view.state().current();
  const auto& good = graph ? graph->unmarked : nullptr;
  if (good) {
    const MarkedImport marked = withMarks(*good, next.marks);
    if (!marked.refused.empty()) return view.say(sentenceOf(marked.refused.front(), view.units()));
  }
  view.state().apply(next, label);
}

const char* cornerName(std::size_t i) {
  constexpr const char* names[] = {QT_TRANSLATE_NOOP("detent::editor::PageTool", "top left corner"),
                                   QT_TRANSLATE_NOOP("detent::editor::PageTool", "top right corner"),
                                   QT_TRANSLATE_NOOP("detent::editor::PageTool", "bottom right corner"),
                                   QT_TRANSLATE_NOOP("detent::editor::PageTool", "bottom left corner")};
  return names[i % 4];
}

}  // namespace

std::vector<PageHandle> handlesOf(const PageView& view) {
  std::vector<PageHandle> handles;
  const auto corners = view.shownCorners();
  if (!corners || !view.state().current()) return handles;
  const Corrections& shown = view.shown();
  for (std::size_t i = 0; i < 4; ++i)
    handles.push_back({Kind::corner, GraphAxis::x, i, view.toWidget((*corners)[i])});
  for (const GraphAxis axis : {GraphAxis::x, GraphAxis::y}) {
    const auto& given = shown.axis(axis).ticks;
    for (std::size_t i = 0; i < given.size(); ++i)
      handles.push_back({Kind::givenTick, axis, i, view.toWidget(given[i].at)});
    const auto& found = axis == GraphAxis::x ? view.drawn().xTicks : view.drawn().yTicks;
    for (std::size_t i = 0; i < found.size(); ++i)
      handles.push_back({Kind::foundTick, axis, i, view.toWidget(found[i].at)});
  }
  const auto& marks = view.drawn().marks;
  for (std::size_t i = 0; i < marks.size(); ++i)
    handles.push_back({Kind::point, GraphAxis::x, i, view.pageToWidget().map(marks[i].at)});
  for (std::size_t i = 0; i < 4; ++i)
    handles.push_back({Kind::edge, GraphAxis::x, i,
                       0.5 * (view.toWidget((*corners)[i]) + view.toWidget((*corners)[(i + 1) % 4]))});
  for (std::size_t i = 0; i < shown.masks.size(); ++i) {
    const auto& box = shown.masks[i];
    handles.push_back(
        {Kind::mask, GraphAxis::x, i, view.toWidget({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)})});
  }
  return handles;
}

std::optional<PageHandle> AdjustTool::handleAt(QPointF widget) const {
  constexpr double reach = 9, edgeReach = 5;
  const auto corners = view_.shownCorners();
  std::optional<PageHandle> nearest;
  double best = reach;
  const auto handles = handlesOf(view_);
  for (const PageHandle& handle : handles) {
    if (handle.kind == Kind::edge || handle.kind == Kind::mask) continue;
    const double d = distanceTo(widget, handle.at);
    if (d < best) best = d, nearest = handle;
  }
  if (nearest) return nearest;
  for (const PageHandle& handle : handles) {
    if (handle.kind == Kind::edge) {
      const QPointF a = view_.toWidget((*corners)[handle.index]),
                    b = view_.toWidget((*corners)[(handle.index + 1) % 4]);
      if (distanceToSegment(widget, a, b) < edgeReach) return handle;
    } else if (handle.kind == Kind::mask &&
               view_.shown().masks[handle.index].contains(view_.toPage(widget))) {
      return handle;
    }
  }
  return {};
}

std::optional<PageHandle> AdjustTool::tickAt(QPointF widget) const {
  constexpr double reach = 14;
  const auto corners = view_.shownCorners();
  if (!corners) return {};
  std::optional<PageHandle> nearest;
  double best = reach;
  for (const PageHandle& handle : handlesOf(view_)) {
    if (handle.kind != Kind::givenTick && handle.kind != Kind::foundTick) continue;
    const QPointF plate = tickPlate(handle.axis, *corners, view_.pageToWidget(), handle.at);
    const double d = std::min(distanceTo(widget, handle.at), distanceTo(widget, plate));
    if (d < best) best = d, nearest = handle;
  }
  return nearest;
}

Corrections AdjustTool::moved(const Drag& drag, QPointF to, Qt::KeyboardModifiers modifiers) const {
  Corrections next = drag.before;
  const importer::Point a = view_.toPage(drag.from), b = view_.toPage(to);
  const importer::Point by{b.x - a.x, b.y - a.y};
  switch (drag.handle.kind) {
    case Kind::corner:
    case Kind::edge: {
      FrameCorners corners = drag.corners;
      if (drag.handle.kind == Kind::corner) {
        moveCorner(corners, drag.handle.index, by, modifiers & Qt::ControlModifier);
      } else {
        moveEdge(corners, drag.handle.index, by);
      }
      for (auto& corner : corners) corner = view_.onPage(corner);
      next.frame = corners;
      break;
    }
    case Kind::givenTick:
    case Kind::foundTick: {
      const bool given = drag.handle.kind == Kind::givenTick;
      const auto& found = drag.handle.axis == GraphAxis::x ? view_.drawn().xTicks : view_.drawn().yTicks;
      AxisCorrection& axis = next.axis(drag.handle.axis);
      AxisTick tick = given ? axis.ticks[drag.handle.index]
                            : AxisTick{found[drag.handle.index].at, found[drag.handle.index].value};
      const auto share = shareAlong(drag.handle.axis, drag.corners, {tick.at.x + by.x, tick.at.y + by.y});
      if (!share) break;
      tick.at = placeAlong(drag.handle.axis, drag.corners, *share);
      axis.min.reset(), axis.max.reset();
      if (given) {
        axis.ticks[drag.handle.index] = tick;
      } else {
        axis.ticks.push_back(tick);
      }
      break;
    }
    case Kind::mask: {
      auto& box = next.masks[drag.handle.index];
      box = {box.x0 + by.x, box.y0 + by.y, box.x1 + by.x, box.y1 + by.y};
      break;
    }
    case Kind::point:
      if (auto mark = markOf(drag.handle)) {
        const importer::Point at = *mark->from;
        mark->to = importer::Point{at.x + by.x, at.y + by.y};
        next.marks = withMark(std::move(next.marks), *mark);
      }
      break;
  }
  return next;
}

QString AdjustTool::label(const PageHandle& handle) const {
  switch (handle.kind) {
    case Kind::corner:
    case Kind::edge:
      return tr("Move plot frame");
    case Kind::givenTick:
    case Kind::foundTick:
      return handle.axis == GraphAxis::x ? tr("Move displacement tick") : tr("Move force tick");
    case Kind::mask:
      return tr("Move mask");
    case Kind::point:
      return tr("Move point");
  }
  return {};
}

bool AdjustTool::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  active_ = handleAt(event.position());
  const auto corners = view_.shownCorners();
  if (!active_ || !corners) return false;
  drag_ = Drag{*active_, event.position(), event.position(), view_.shown(), *corners};
  view_.setMagnifier(event.position());
  return true;
}

bool AdjustTool::move(const QMouseEvent& event) {
  if (!drag_) {
    const auto now = handleAt(event.position());
    if (now != hovered_) hovered_ = now, view_.update();
    return false;
  }
  constexpr double startsAt_px = 2;  // a click is not a drag
  if (!drag_->moved && distanceTo(drag_->from, event.position()) < startsAt_px) return true;
  drag_->moved = true;
  drag_->to = event.position();
  view_.setMagnifier(event.position());
  view_.setPreview(moved(*drag_, event.position(), event.modifiers()));
  return true;
}

bool AdjustTool::release(const QMouseEvent& event) {
  if (!drag_) return false;
  const Drag done = *drag_;
  drag_.reset();
  view_.setMagnifier({});
  view_.setPreview({});
  if (done.moved) {
    if (done.handle.kind == Kind::foundTick) {  // a moved tick counts as given by hand
      active_ =
          PageHandle{Kind::givenTick, done.handle.axis, done.before.axis(done.handle.axis).ticks.size(), {}};
    }
    const Corrections next = moved(done, event.position(), event.modifiers());
    if (done.handle.kind == Kind::point)
      takeMarks(view_, next, label(done.handle));
    else
      view_.state().apply(next, label(done.handle));
  }
  view_.update();
  return true;
}

bool AdjustTool::typeValue(const PageHandle& handle) {
  if (handle.kind == Kind::givenTick) {
    view_.askValue(handle.axis, view_.shown().axis(handle.axis).ticks[handle.index].at, handle.index);
    return true;
  }
  if (handle.kind == Kind::foundTick) {
    const auto& found = handle.axis == GraphAxis::x ? view_.drawn().xTicks : view_.drawn().yTicks;
    view_.askValue(handle.axis, found[handle.index].at, {});
    return true;
  }
  return false;
}

bool AdjustTool::doubleClick(const QMouseEvent& event) {
  cancel();
  const auto tick = tickAt(event.position());
  return tick && typeValue(*tick);
}

std::optional<MarkCorrection> AdjustTool::markOf(const PageHandle& handle) const {
  const auto& marks = view_.drawn().marks;
  if (handle.index >= marks.size()) return {};
  const DrawnMark& mark = marks[handle.index];
  const auto kind = mark.kind == DrawnMark::Kind::tactile     ? MarkCorrection::Kind::tactile
                    : mark.kind == DrawnMark::Kind::operating ? MarkCorrection::Kind::operating
                                                              : MarkCorrection::Kind::reset;
  return MarkCorrection{kind, mark.stroke, importer::Point{mark.at.x(), mark.at.y()}, {}};
}

void AdjustTool::give(const MarkCorrection& mark, const QString& label) {
  Corrections next = view_.shown();
  next.marks = withMark(std::move(next.marks), mark);
  takeMarks(view_, next, label);
}

// Menu of the points that can be added at the pointer, and of removing the point under it.
bool AdjustTool::menu(QPointF widget, QPoint global) {
  if (!view_.drawn().press) return false;
  auto under = handleAt(widget);
  if (!under || under->kind != Kind::point)
    under = active_ && active_->kind == Kind::point ? active_ : std::nullopt;
  auto* menu = new QMenu(&view_);
  menu->setObjectName(QStringLiteral("pointMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto mark = under ? markOf(*under) : std::nullopt;
  PageView& view = view_;
  const auto change = [&view](MarkCorrection next, const QString& label) {
    Corrections corrections = view.shown();
    corrections.marks = withMark(std::move(corrections.marks), next);
    takeMarks(view, corrections, label);
  };
  if (mark)
    menu->addAction(tr("Remove this point"), &view, [change, mark] { change(*mark, tr("Remove point")); });
  const importer::Point at = view_.onPage(view_.toPage(widget));
  const auto add = [&](const QString& text, MarkCorrection::Kind kind, Stroke stroke) {
    menu->addAction(text, &view, [change, at, kind, stroke] {
      change(MarkCorrection{kind, stroke, {}, at}, tr("Add point"));
    });
  };
  add(tr("Set operating point here"), MarkCorrection::Kind::operating, Stroke::press);
  if (view_.drawn().release) add(tr("Set reset point here"), MarkCorrection::Kind::reset, Stroke::release);
  add(tr("Set tactile point of the press here"), MarkCorrection::Kind::tactile, Stroke::press);
  if (view_.drawn().release)
    add(tr("Set tactile point of the release here"), MarkCorrection::Kind::tactile, Stroke::release);
  menu->popup(global);
  return true;
}

bool AdjustTool::remove(const PageHandle& handle) {
  Corrections next = view_.shown();
  if (handle.kind == Kind::point) {
    const auto mark = markOf(handle);
    active_.reset();
    if (mark) give(*mark, tr("Remove point"));
    return mark.has_value();
  }
  if (handle.kind == Kind::mask && handle.index < next.masks.size()) {
    next.masks.erase(next.masks.begin() + static_cast<std::ptrdiff_t>(handle.index));
  } else if (handle.kind == Kind::givenTick && handle.index < next.axis(handle.axis).ticks.size()) {
    auto& ticks = next.axis(handle.axis).ticks;
    ticks.erase(ticks.begin() + static_cast<std::ptrdiff_t>(handle.index));
  } else {
    return false;
  }
  active_.reset();
  view_.state().apply(next, handle.kind == Kind::mask ? tr("Remove mask") : tr("Remove tick"));
  return true;
}

bool AdjustTool::nudge(QPointF widgetDelta) {
  const auto corners = view_.shownCorners();
  if (!active_ || !corners) return false;
  const PageHandle handle = *active_;
  const Drag step{handle, QPointF(0, 0), QPointF(0, 0), view_.shown(), *corners};
  if (handle.kind == Kind::foundTick)
    active_ = PageHandle{Kind::givenTick, handle.axis, step.before.axis(handle.axis).ticks.size(), {}};
  if (handle.kind == Kind::point)
    takeMarks(view_, moved(step, widgetDelta, {}), label(handle));
  else
    view_.state().apply(moved(step, widgetDelta, {}), label(handle), QStringLiteral("nudge"));
  return true;
}

bool AdjustTool::key(const QKeyEvent& event) {
  const double step_px = event.modifiers() & Qt::ShiftModifier ? 10
                         : event.modifiers() & Qt::AltModifier ? 0.1
                                                               : 1;
  switch (event.key()) {
    case Qt::Key_Left:
      return nudge({-step_px, 0});
    case Qt::Key_Right:
      return nudge({step_px, 0});
    case Qt::Key_Up:
      return nudge({0, -step_px});
    case Qt::Key_Down:
      return nudge({0, step_px});
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_F2:
      return active_ && typeValue(*active_);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return active_ && remove(*active_);
    default:
      return false;
  }
}

bool AdjustTool::selectNext(bool forward) {
  const auto handles = handlesOf(view_);
  if (handles.empty()) return false;
  const auto at = active_ ? std::find(handles.begin(), handles.end(), *active_) : handles.end();
  if (at == handles.end()) {
    active_ = forward ? handles.front() : handles.back();
  } else if (forward ? at + 1 == handles.end() : at == handles.begin()) {
    active_.reset();
    view_.update();
    return false;
  } else {
    active_ = forward ? *(at + 1) : *(at - 1);
  }
  view_.update();
  return true;
}

void AdjustTool::cancel() {
  drag_.reset();
  view_.setMagnifier({});
  view_.setPreview({});
}

void AdjustTool::paint(QPainter& painter) const {
  const GraphColors colors = view_.colors();
  const auto same = [](const std::optional<PageHandle>& a, const PageHandle& b) { return a && *a == b; };
  for (const PageHandle& handle : handlesOf(view_)) {
    const bool lit = same(active_, handle) || same(hovered_, handle);
    if (handle.kind == Kind::corner) {
      const double half = lit ? 6 : 4.5;
      painter.setPen(QPen(Qt::white, 3));
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(QRectF(handle.at - QPointF(half, half), QSizeF(2 * half, 2 * half)));
      painter.setPen(QPen(QColor("#00805c"), 1.5));
      painter.setBrush(lit ? QColor("#00805c") : QColor(Qt::white));
      painter.drawRect(QRectF(handle.at - QPointF(half, half), QSizeF(2 * half, 2 * half)));
    } else if (drag_ && drag_->moved && handle.kind == Kind::point && *active_ == handle) {
      continue;  // the dragged mark is drawn at its new place
    } else if (lit && handle.kind != Kind::edge) {
      painter.setPen(QPen(colors.refused, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(handle.at, 9, 9);
    }
  }
  paintDraggedPoint(painter);
}

void AdjustTool::paintDraggedPoint(QPainter& painter) const {
  if (!drag_ || !drag_->moved || drag_->handle.kind != Kind::point) return;
  painter.setPen(QPen(view_.colors().refused, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(drag_->to, 7, 7);
  painter.drawLine(drag_->from, drag_->to);
}

QCursor AdjustTool::cursor(QPointF widget) const {
  const auto handle = drag_ ? std::optional(drag_->handle) : handleAt(widget);
  if (!handle) return Qt::ArrowCursor;
  if (handle->kind == Kind::edge) {
    const auto corners = view_.shownCorners();
    const QPointF d =
        view_.toWidget((*corners)[handle->index]) - view_.toWidget((*corners)[(handle->index + 1) % 4]);
    return std::abs(d.x()) > std::abs(d.y()) ? Qt::SizeVerCursor : Qt::SizeHorCursor;
  }
  if (handle->kind == Kind::corner) return Qt::CrossCursor;
  return Qt::PointingHandCursor;
}

QString AdjustTool::hint() const {
  if (active_ && active_->kind == Kind::corner) {
    return tr("Drag the %1 of the plot frame, or use the arrow keys (Shift: 10 times the step, Alt: a "
              "tenth). Ctrl keeps the frame rectangular.")
        .arg(tr(cornerName(active_->index)));
  }
  return tr(
      "Drag corners and edges of the plot frame, ticks, or points of the curve. Right-click to add a point. "
      "Double-click a tick to type its value. Tab selects the next element, arrow keys move it, Delete "
      "removes it.");
}

}  // namespace detent::editor
