// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/damping_view.h"

#include <algorithm>
#include <cmath>
#include <QMouseEvent>

#include "editor/canvas/curve_path.h"
#include "editor/canvas/graph_painting.h"
#include "editor/document/message_words.h"
#include "model/edits.h"

namespace detent::editor {
namespace {

constexpr double dampingReach_px = 9;
constexpr double dampingNudge_mm = 0.01, dampingNudge_Ns_per_mm = 0.001;

}  // namespace

DampingView::DampingView(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : UnitPlot(settings, PlotQuantity::displacement, PlotQuantity::damping, parent), document_(document) {
  setObjectName(QStringLiteral("dampingView"));
  setAccessibleName(tr("Damping over displacement"));
  setToolTip(
      tr("Drag points to move them. Double-click the line to add a point; Delete removes the selected one."));
  const auto follow = [this] {
    if (selected_ && *selected_ >= points().size()) select({});
    if (fitted() && !dragging_) fit();
    update();
  };
  connect(&document_, &ButtonDocument::changed, this, follow);
  connect(&document_, &ButtonDocument::activeStateChanged, this, follow);
  connect(&document_, &ButtonDocument::activeStateChanged, this, &DampingView::cancelDrag);
  connect(&document_.history().stack(), &QUndoStack::indexChanged, this, &DampingView::cancelDrag);
  fit();
}

const std::vector<DampingPoint>& DampingView::points() const {
  return document_.button().states()[document_.activeState()].damping;
}

QRectF DampingView::contentRange() const {
  double high = 1e-3;
  for (const DampingPoint& p : points()) high = std::max(high, p.damping_Ns_per_mm);
  return {0, 0, document_.graph().travel_mm(), 1.15 * high};
}

void DampingView::drawContent(QPainter& painter, const PlotMapping& map) const {
  painter.save();
  painter.setClipRect(map.clip_px);
  QPolygonF line;
  for (const DampingPoint& p : points()) line.push_back(map.toPixel(p.displacement_mm, p.damping_Ns_per_mm));
  if (!line.empty()) {  // beyond its points damping is constant
    QPolygonF whole = line;
    whole.prepend({map.clip_px.left() - 1, line.front().y()});
    whole.append({map.clip_px.right() + 1, line.back().y()});
    painter.setPen(QPen(colors().operatingPoint, 2));
    for (const QPolygonF& part : clippedPolylines(whole, map.clip_px)) painter.drawPolyline(part);
  }
  for (qsizetype i = 0; i < line.size(); ++i) {
    const bool chosen = selected_ && static_cast<qsizetype>(*selected_) == i;
    painter.setPen(QPen(chosen ? colors().selection : colors().operatingPoint, chosen ? 2 : 1.5));
    painter.setBrush(colors().background);
    painter.drawEllipse(line[i], 5, 5);
  }
  if (!refused_.isEmpty() && selected_ && static_cast<qsizetype>(*selected_) < line.size())
    paintTag(painter, line[static_cast<qsizetype>(*selected_)] + QPointF(0, -22), refused_, colors().refused,
             colors().background, map.clip_px);
  painter.restore();
}

std::optional<std::size_t> DampingView::pointAt(QPointF px) const {
  const PlotMapping map = mapping();
  std::optional<std::size_t> best;
  double reach = dampingReach_px;
  for (std::size_t i = 0; i < points().size(); ++i) {
    const QPointF off = map.toPixel(points()[i].displacement_mm, points()[i].damping_Ns_per_mm) - px;
    if (std::hypot(off.x(), off.y()) > reach) continue;
    reach = std::hypot(off.x(), off.y());
    best = i;
  }
  return best;
}

void DampingView::select(std::optional<std::size_t> index) {
  selected_ = index;
  refused_.clear();
  if (index && *index < points().size()) {
    const DampingPoint& p = points()[*index];
    const QString name =
        tr("Damping point %1: %2, %3")
            .arg(*index + 1)
            .arg(quantityWithUnit(p.displacement_mm, Quantity::length, settings().units()),
                 quantityWithUnit(p.damping_Ns_per_mm, Quantity::damping, settings().units()));
    setAccessibleName(name);
    emit said(name);
  } else {
    setAccessibleName(tr("Damping over displacement"));
  }
  update();
}

void DampingView::refuse(const QString& why) {
  refused_ = why;
  emit said(why);
  update();
}

void DampingView::cancelDrag() {
  grab_px_.reset();
  if (!dragging_) return;
  dragging_ = false;
  document_.history().cancelDrag();
}

void DampingView::apply(std::vector<DampingPoint> next, const QString& label, const QString& mergeKey) {
  if (document_.history().dragging()) return;
  const auto button = setDamping(document_.history().committed(), document_.activeState(), std::move(next));
  if (!button) return refuse(sentenceOf(button.failure()));
  refused_.clear();
  document_.history().apply(*button, label, mergeKey);
}

void DampingView::movePoint(std::size_t index, DampingPoint to) {
  const std::size_t state = document_.activeState();
  std::vector<DampingPoint> next = document_.history().committed().states()[state].damping;
  next[index] = to;
  const auto button = setDamping(document_.history().committed(), state, std::move(next));
  if (!button) return refuse(sentenceOf(button.failure()));
  refused_.clear();
  document_.history().preview(*button);
}

void DampingView::mousePressEvent(QMouseEvent* event) {
  UnitPlot::mousePressEvent(event);
  if (event->button() != Qt::LeftButton || document_.history().dragging()) return;
  select(pointAt(event->position()));
  if (!selected_) return;
  const DampingPoint& p = points()[*selected_];
  grab_px_ = event->position() - mapping().toPixel(p.displacement_mm, p.damping_Ns_per_mm);
}

void DampingView::mouseMoveEvent(QMouseEvent* event) {
  UnitPlot::mouseMoveEvent(event);
  if (!grab_px_ || !selected_) return;
  if (!(event->buttons() & Qt::LeftButton)) return endDrag();  // the mouse release went to another window
  if (!dragging_ && document_.history().dragging()) return;
  if (!dragging_) document_.history().beginDrag(tr("Move damping point %1").arg(*selected_ + 1));
  dragging_ = true;
  const QPointF to = mapping().toPlot(event->position() - *grab_px_);
  movePoint(*selected_, {to.x(), to.y()});
}

void DampingView::mouseReleaseEvent(QMouseEvent* event) {
  UnitPlot::mouseReleaseEvent(event);
  if (event->button() == Qt::LeftButton) endDrag();
}

void DampingView::endDrag() {
  grab_px_.reset();
  refused_.clear();
  update();
  if (!dragging_) return;
  dragging_ = false;
  document_.history().finishDrag();
}

void DampingView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || points().empty() || pointAt(event->position())) return;
  const QPointF at = mapping().toPlot(event->position());
  std::vector<DampingPoint> next = points();
  const auto after = std::find_if(next.begin(), next.end(),
                                  [&](const DampingPoint& p) { return p.displacement_mm > at.x(); });
  const auto index = static_cast<std::size_t>(after - next.begin());
  next.insert(after, {at.x(), at.y()});
  apply(std::move(next), tr("Add damping point"));
  if (index < points().size() && points()[index].displacement_mm == at.x()) select(index);
}

bool DampingView::selectBy(int by) {
  const int count = static_cast<int>(points().size());
  const int next = selected_ ? static_cast<int>(*selected_) + by : by > 0 ? 0 : count - 1;
  if (next < 0 || next >= count) {
    select({});
    return false;
  }
  select(static_cast<std::size_t>(next));
  return true;
}

bool DampingView::nudge(int key, Qt::KeyboardModifiers modifiers) {
  const double times = modifiers & Qt::ShiftModifier ? 10 : modifiers & Qt::AltModifier ? 0.1 : 1;
  std::vector<DampingPoint> next = points();
  DampingPoint& point = next[*selected_];
  if (key == Qt::Key_Left) point.displacement_mm -= times * dampingNudge_mm;
  if (key == Qt::Key_Right) point.displacement_mm += times * dampingNudge_mm;
  if (key == Qt::Key_Down) point.damping_Ns_per_mm -= times * dampingNudge_Ns_per_mm;
  if (key == Qt::Key_Up) point.damping_Ns_per_mm += times * dampingNudge_Ns_per_mm;
  if (next == points()) return false;
  apply(std::move(next), tr("Move damping point %1").arg(*selected_ + 1),
        QStringLiteral("nudge/damping/%1/%2").arg(document_.activeState()).arg(*selected_));
  return true;
}

void DampingView::keyPressEvent(QKeyEvent* event) {
  if (dragging_) {
    if (event->key() == Qt::Key_Escape) cancelDrag();
    return;
  }
  if (!selected_) return UnitPlot::keyPressEvent(event);
  if (event->key() == Qt::Key_Escape) return select({});
  if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
    std::vector<DampingPoint> next = points();
    next.erase(next.begin() + static_cast<std::ptrdiff_t>(*selected_));
    return apply(std::move(next), tr("Remove damping point %1").arg(*selected_ + 1));
  }
  if (!nudge(event->key(), event->modifiers())) UnitPlot::keyPressEvent(event);
}

bool DampingView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && (selected_ || dragging_)) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Delete || key == Qt::Key_Backspace || key == Qt::Key_Escape) {
      event->accept();
      return true;
    }
  }
  if (event->type() == QEvent::KeyPress && !dragging_) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Tab && selectBy(1)) return true;
    if (key->key() == Qt::Key_Backtab && selectBy(-1)) return true;
  }
  return UnitPlot::event(event);
}

void DampingView::resizeEvent(QResizeEvent* event) {
  UnitPlot::resizeEvent(event);
  if (fitted()) fit();
}

}  // namespace detent::editor
