// SPDX-License-Identifier: GPL-3.0-or-later
// The tools with one gesture each: set a value, draw a frame, pick a colour, paint a mask, drag the page.

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/importing/adjust_tool.h"
#include "editor/importing/page_tool.h"

namespace detent::editor {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("detent::editor::PageTool", text); }

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

importer::Rgb rgbOf(const QColor& c) {
  return {static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
          static_cast<std::uint8_t>(c.blue())};
}

importer::Box boxOf(importer::Point a, importer::Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

/// Sets a tick: a click selects a place of an axis, and its value is typed there. Snaps to ticks, gridlines
/// and the ends of the axis.
class ScaleTool : public PageTool {
 public:
  using PageTool::PageTool;
  bool press(const QMouseEvent& event) override {
    if (event.button() != Qt::LeftButton) return false;
    const auto target = targetAt(event.position());
    if (!target) return false;
    if (target->isOrigin)
      view_.askOrigin(target->at);
    else
      view_.askValue(target->axis, target->at, {});
    return true;
  }
  bool move(const QMouseEvent& event) override {
    target_ = targetAt(event.position());
    view_.setMagnifier(target_ ? std::optional(event.position()) : std::nullopt);
    view_.update();
    return true;
  }
  bool release(const QMouseEvent&) override { return true; }
  void cancel() override {
    target_.reset();
    view_.setMagnifier({});
  }
  void paint(QPainter& painter) const override {
    if (!target_) return;
    const QPointF at = view_.toWidget(target_->at);
    painter.setPen(QPen(view_.colors().refused, 2));
    const auto corners = view_.shownCorners();
    if (corners) {
      for (const GraphAxis axis : {GraphAxis::x, GraphAxis::y})
        if (target_->isOrigin || axis == target_->axis)
          painter.drawLine(at, view_.toWidget(acrossFrom(axis, *corners)));
    }
    painter.drawEllipse(at, 6, 6);
  }
  QCursor cursor(QPointF) const override { return Qt::CrossCursor; }
  QString hint() const override {
    return tr(
        "Click a tick of an axis and type the value printed there. Two ticks define an axis. The corner "
        "where the axes meet sets both at once.");
  }

 private:
  static constexpr double clings_px = 8;
  struct Target {
    GraphAxis axis = GraphAxis::x;
    importer::Point at;
    bool isOrigin = false;  ///< true if both axes begin here
  };

  /// The other end of the gridline through the target.
  importer::Point acrossFrom(GraphAxis axis, const FrameCorners& c) const {
    const FrameCorners turned =
        axis == GraphAxis::x ? FrameCorners{c[3], c[2], c[1], c[0]} : FrameCorners{c[1], c[0], c[3], c[2]};
    return placeAlong(axis, turned, shareAlong(axis, c, target_->at).value_or(0));
  }

  std::optional<Target> targetAt(QPointF widget) const {
    const auto corners = view_.shownCorners();
    if (!corners) return {};
    if (distance(widget, view_.toWidget((*corners)[3])) <= clings_px)
      return Target{GraphAxis::x, (*corners)[3], true};
    const auto projectionOn = [&](GraphAxis axis) -> std::optional<importer::Point> {
      const auto share = shareAlong(axis, *corners, view_.toPage(widget));
      if (!share) return {};
      return placeAlong(axis, *corners, *share);
    };
    const auto x = projectionOn(GraphAxis::x), y = projectionOn(GraphAxis::y);
    if (!x || !y) return {};
    const bool nearX = distance(widget, view_.toWidget(*x)) <= distance(widget, view_.toWidget(*y));
    const Target onAxis{nearX ? GraphAxis::x : GraphAxis::y, nearX ? *x : *y};
    Target target = onAxis;
    double best = clings_px;
    const auto cling = [&](importer::Point place) {
      const double d = distance(view_.toWidget(onAxis.at), view_.toWidget(place));
      if (d < best) best = d, target.at = place;
    };
    for (const QPointF& line : nearX ? view_.drawn().xLines : view_.drawn().yLines)
      cling({line.x(), line.y()});
    for (const double end : {0.0, 1.0}) cling(placeAlong(onAxis.axis, *corners, end));
    return target;
  }

  std::optional<Target> target_;
};

/// A rectangle from corner to corner; subclasses decide its use. What is shown is what is used.
class RectangleTool : public PageTool {
 public:
  using PageTool::PageTool;
  bool press(const QMouseEvent& event) override {
    if (event.button() != Qt::LeftButton) return false;
    from_ = view_.onPage(view_.toPage(event.position()));
    box_ = boxOf(*from_, *from_);
    return true;
  }
  bool move(const QMouseEvent& event) override {
    if (!from_) return false;
    box_ = boxTo(event);
    view_.setMagnifier(event.position());
    view_.update();
    return true;
  }
  bool release(const QMouseEvent& event) override {
    if (!from_) return false;
    box_ = boxTo(event);
    const QRectF seen = shown();
    cancel();
    constexpr double least_px = 4;
    if (seen.width() >= least_px && seen.height() >= least_px) take(box_);
    return true;
  }
  bool busy() const override { return from_.has_value(); }
  void cancel() override {
    from_.reset();
    view_.setMagnifier({});
    view_.update();
  }
  void paint(QPainter& painter) const override {
    if (!from_) return;
    painter.setPen(QPen(view_.colors().refused, 1.5, Qt::DashLine));
    painter.setBrush(QColor(213, 94, 0, 40));
    painter.drawRect(shown());
  }
  QCursor cursor(QPointF) const override { return Qt::CrossCursor; }

 protected:
  virtual void take(const importer::Box& box) = 0;
  /// The box that is meant by the drawn one.
  virtual importer::Box meant(const importer::Box& drawn) const { return drawn; }

 private:
  // Ctrl draws freely, as it does on the graph of a button.
  importer::Box boxTo(const QMouseEvent& event) const {
    const importer::Box drawn = boxOf(*from_, view_.onPage(view_.toPage(event.position())));
    return event.modifiers() & Qt::ControlModifier ? drawn : meant(drawn);
  }
  QRectF shown() const {
    return QRectF(view_.toWidget({box_.x0, box_.y0}), view_.toWidget({box_.x1, box_.y1})).normalized();
  }

  std::optional<importer::Point> from_;
  importer::Box box_;
};

class MaskBoxTool : public RectangleTool {
 public:
  using RectangleTool::RectangleTool;
  QString hint() const override {
    return tr("Drag a rectangle over parts that are not a curve: texts, arrows, stamps.");
  }

 private:
  void take(const importer::Box& box) override {
    if (!view_.state().current()) return;
    Corrections next = view_.shown();
    next.masks.push_back(box);
    view_.state().apply(next, tr("Mask rectangle"));
  }
};

/// Returns true if two frames belong to one graph: each covers much of the other.
bool isSameGraph(const FrameCorners& a, const FrameCorners& b) {
  constexpr double leastShare = 0.3;
  const auto boxOfFrame = [](const FrameCorners& c) {
    QPolygonF outline;
    for (const importer::Point& p : c) outline << QPointF(p.x, p.y);
    return outline.boundingRect();
  };
  const QRectF x = boxOfFrame(a), y = boxOfFrame(b), united = x & y;
  return united.width() * united.height() >=
         leastShare * std::min(x.width() * x.height(), y.width() * y.height());
}

/// Snaps an edge of a frame that is drawn by hand to a drawn line of the page.
class LineSnap {
 public:
  explicit LineSnap(PageView& view)
      : picture_(view.state().sheet() ? &view.state().sheet()->picture : nullptr) {
    const QPointF step = view.pageToWidget().map(QPointF(1, 0)) - view.pageToWidget().map(QPointF(0, 0));
    reach_ = reach_px / std::max(1e-9, std::hypot(step.x(), step.y()));
  }

  importer::Box snapped(const importer::Box& box) const {
    if (!picture_ || picture_->empty()) return box;
    const double x0 = nearest(box.x0, box.y0, box.y1, true), x1 = nearest(box.x1, box.y0, box.y1, true);
    const double y0 = nearest(box.y0, box.x0, box.x1, false), y1 = nearest(box.y1, box.x0, box.x1, false);
    return x0 < x1 && y0 < y1 ? importer::Box{x0, y0, x1, y1} : box;
  }

 private:
  static constexpr double reach_px = 7;     // pixels of the screen; a user does not use a magnifier
  static constexpr int samples = 48;        // along an edge
  static constexpr int leastContrast = 40;  // grey levels between a line and its background
  // share of the edge along which the line must be visible; a dashed line reaches it
  static constexpr double leastShare = 0.6;

  std::optional<int> grey(double across, double along, bool upright) const {
    const auto color = picture_->colorAt(upright ? QPointF(across, along) : QPointF(along, across));
    return color ? std::optional(qGray(color->rgb())) : std::nullopt;
  }

  // The position within reach at which most of the edge has dark pixels; the middle of a thick line.
  double nearest(double edge, double from, double to, bool upright) const {
    const double step = 0.5 / picture_->pixelsPerUnit();
    const int offsets = static_cast<int>(reach_ / step);
    std::vector<int> seen(static_cast<std::size_t>(2 * offsets + 1), 0);
    for (int i = 0; i < samples; ++i) {
      const double along = from + (0.1 + 0.8 * i / (samples - 1)) * (to - from);
      std::vector<int> greys;
      for (int k = -offsets; k <= offsets; ++k)
        greys.push_back(grey(edge + k * step, along, upright).value_or(-1));
      std::vector<int> sorted = greys;
      std::nth_element(sorted.begin(), sorted.begin() + offsets, sorted.end());
      const int background = sorted[static_cast<std::size_t>(offsets)];
      for (std::size_t k = 0; k < greys.size(); ++k)
        if (greys[k] >= 0 && std::abs(greys[k] - background) >= leastContrast) ++seen[k];
    }
    const auto best = std::max_element(seen.begin(), seen.end());
    if (*best < leastShare * samples) return edge;
    const auto end = std::find_if(best, seen.end(), [&](int count) { return count < *best; });
    const double middle =
        static_cast<double>(best - seen.begin()) + 0.5 * static_cast<double>(end - best - 1);
    return edge + (middle - offsets) * step;
  }

  const PagePicture* picture_;
  double reach_ = 0;  // page units
};

class DrawFrameTool : public RectangleTool {
 public:
  using RectangleTool::RectangleTool;
  QString hint() const override {
    return tr(
        "Drag across the area in which the curves are drawn, from corner to corner. Over the current plot "
        "frame, the new one replaces it; elsewhere, it adds a graph. Edges snap to lines close to them; Ctrl "
        "draws freely.");
  }

 private:
  importer::Box meant(const importer::Box& drawn) const override { return LineSnap(view_).snapped(drawn); }
  void take(const importer::Box& box) override {
    const FrameCorners frame{{{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}}};
    const auto shown = view_.shownCorners();
    if (view_.state().current() && (!shown || isSameGraph(frame, *shown))) {
      Corrections next = view_.shown();
      next.frame = frame;
      view_.state().apply(next, tr("Draw plot frame"));
    } else {
      view_.state().addGraph(frame);
    }
    view_.setTool(PageToolKind::adjust);
  }
};

/// A square brush, because masks are boxes.
class MaskBrushTool : public PageTool {
 public:
  using PageTool::PageTool;
  bool press(const QMouseEvent& event) override {
    if (event.button() != Qt::LeftButton || !view_.state().current()) return false;
    before_ = view_.shown();
    painted_.clear();
    dab(event.position());
    return true;
  }
  bool move(const QMouseEvent& event) override {
    at_ = event.position();
    view_.update();
    if (!before_) return false;
    const double spacing = 0.5 * side_px;
    while (distance(last_, event.position()) >= spacing) {
      const QPointF d = event.position() - last_;
      dab(last_ + d * (spacing / distance(last_, event.position())));
    }
    return true;
  }
  bool release(const QMouseEvent&) override {
    if (!before_) return false;
    const Corrections next = painted();
    before_.reset();
    view_.setPreview({});
    view_.state().apply(next, tr("Paint mask"));
    return true;
  }
  bool key(const QKeyEvent& event) override {
    if (event.key() == Qt::Key_BracketLeft)
      side_px = std::max(4.0, side_px / 1.25);
    else if (event.key() == Qt::Key_BracketRight)
      side_px = std::min(120.0, side_px * 1.25);
    else
      return false;
    view_.update();
    return true;
  }
  bool busy() const override { return before_.has_value(); }
  void cancel() override {
    before_.reset();
    view_.setPreview({});
  }
  void paint(QPainter& painter) const override {
    painter.setPen(QPen(view_.colors().refused, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(at_ - QPointF(side_px / 2, side_px / 2), QSizeF(side_px, side_px)));
  }
  QCursor cursor(QPointF) const override { return Qt::BlankCursor; }
  QString hint() const override {
    return tr("Paint over parts that are not a curve. [ and ] change the size of the brush.");
  }

 private:
  Corrections painted() const {
    Corrections next = *before_;
    next.masks.insert(next.masks.end(), painted_.begin(), painted_.end());
    return next;
  }
  void dab(QPointF at) {
    last_ = at;
    const QPointF half(side_px / 2, side_px / 2);
    painted_.push_back(boxOf(view_.toPage(at - half), view_.toPage(at + half)));
    view_.setPreview(painted());
  }

  double side_px = 22;
  std::optional<Corrections> before_;
  std::vector<importer::Box> painted_;
  QPointF last_, at_;
};

/// Draws a curve by clicks or by a drag. The line between the points is moved to the curve's pixels later.
class DrawCurveTool : public PageTool {
 public:
  DrawCurveTool(PageView& view, Stroke stroke) : PageTool(view), stroke_(stroke) {}
  bool press(const QMouseEvent& event) override {
    if (event.button() != Qt::LeftButton || !view_.state().current()) return false;
    add(event.position());
    held_ = true;
    drawn_ = false;
    return true;
  }
  bool move(const QMouseEvent& event) override {
    at_ = event.position();
    view_.setMagnifier(at_);
    if (held_ && distance(view_.toWidget(points_.back()), at_) >= drawnEvery_px) {
      add(at_);
      drawn_ = true;
    }
    view_.update();
    return true;
  }
  bool release(const QMouseEvent& event) override {
    if (held_ && drawn_ && distance(view_.toWidget(points_.back()), event.position()) >= 1)
      add(event.position());
    held_ = false;
    return true;
  }
  bool doubleClick(const QMouseEvent&) override {
    finish();
    return true;
  }
  bool key(const QKeyEvent& event) override {
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) return finish();
    if (event.key() != Qt::Key_Backspace || points_.empty()) return false;
    points_.pop_back();
    held_ = false;
    view_.update();
    return true;
  }
  bool busy() const override { return !points_.empty(); }
  void cancel() override {
    points_.clear();
    held_ = false;
    view_.setMagnifier({});
    view_.update();
  }
  void paint(QPainter& painter) const override {
    QPolygonF line;
    for (const importer::Point& p : points_) line << view_.toWidget(p);
    if (!line.isEmpty() && !held_) line << at_;
    const QColor strokeColor = stroke_ == Stroke::press ? view_.colors().press : view_.colors().release;
    painter.setPen(QPen(strokeColor, 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.setBrush(strokeColor);
    for (const importer::Point& p : points_) painter.drawEllipse(view_.toWidget(p), 2.5, 2.5);
  }
  QCursor cursor(QPointF) const override { return Qt::CrossCursor; }
  QString hint() const override {
    return stroke_ == Stroke::press
               ? tr("Click points along the press curve, or draw along it. Press Enter or double-click to "
                    "finish. To correct part of a traced curve, draw over that part.")
               : tr("Click points along the release curve, or draw along it. Press Enter or double-click to "
                    "finish. To correct part of a traced curve, draw over that part.");
  }

 private:
  static constexpr double drawnEvery_px = 12;
  void add(QPointF widget) { points_.push_back(view_.onPage(view_.toPage(widget))); }
  bool finish() {
    if (points_.size() < 2 || !view_.state().current()) return false;
    Corrections next = view_.shown();
    (stroke_ == Stroke::press ? next.drawn.press : next.drawn.release) = points_;
    if (stroke_ == Stroke::release) next.noRelease = false;
    cancel();
    view_.setTool(PageToolKind::adjust);
    view_.state().apply(next, stroke_ == Stroke::press ? tr("Draw press curve") : tr("Draw release curve"));
    return true;
  }

  Stroke stroke_;
  std::vector<importer::Point> points_;
  bool held_ = false, drawn_ = false;  ///< the mouse button is down; the pointer was moved since
  QPointF at_;
};

class PipetteTool : public PageTool {
 public:
  PipetteTool(PageView& view, Stroke stroke) : PageTool(view), stroke_(stroke) {}
  bool press(const QMouseEvent& event) override { return event.button() == Qt::LeftButton; }
  bool move(const QMouseEvent& event) override {
    at_ = event.position();
    view_.setMagnifier(at_);
    view_.update();
    return true;
  }
  bool release(const QMouseEvent& event) override {
    const auto color = view_.curveColorAt(event.position());
    if (!color || !view_.state().current()) return false;
    Corrections next = view_.shown();
    (stroke_ == Stroke::press ? next.pressColor : next.releaseColor) = rgbOf(*color);
    if (stroke_ == Stroke::release) next.noRelease = false;
    view_.setTool(PageToolKind::adjust);
    view_.state().apply(next, stroke_ == Stroke::press ? tr("Pick press curve") : tr("Pick release curve"));
    return true;
  }
  void cancel() override { view_.setMagnifier({}); }
  void paint(QPainter& painter) const override {
    const auto color = at_.isNull() ? std::nullopt : view_.curveColorAt(at_);
    if (!color) return;
    painter.setPen(QPen(Qt::white, 3));
    painter.setBrush(*color);
    painter.drawRect(QRectF(at_ + QPointF(14, -34), QSizeF(22, 22)));
    painter.setPen(QPen(Qt::black, 1));
    painter.drawRect(QRectF(at_ + QPointF(14, -34), QSizeF(22, 22)));
  }
  QCursor cursor(QPointF) const override { return Qt::CrossCursor; }
  QString hint() const override {
    return stroke_ == Stroke::press ? tr("Click the press curve.") : tr("Click the release curve.");
  }

 private:
  Stroke stroke_;
  QPointF at_;
};

class PanTool : public PageTool {
 public:
  using PageTool::PageTool;
  bool press(const QMouseEvent& event) override {
    if (event.button() != Qt::LeftButton) return false;
    from_ = event.position();
    return true;
  }
  bool move(const QMouseEvent& event) override {
    if (!from_) return false;
    view_.panBy(event.position() - *from_);
    from_ = event.position();
    return true;
  }
  bool release(const QMouseEvent&) override {
    from_.reset();
    return true;
  }
  bool key(const QKeyEvent& event) override {
    constexpr double step = 40;
    if (event.key() == Qt::Key_Left)
      view_.panBy({step, 0});
    else if (event.key() == Qt::Key_Right)
      view_.panBy({-step, 0});
    else if (event.key() == Qt::Key_Up)
      view_.panBy({0, step});
    else if (event.key() == Qt::Key_Down)
      view_.panBy({0, -step});
    else
      return false;
    return true;
  }
  QCursor cursor(QPointF) const override { return from_ ? Qt::ClosedHandCursor : Qt::OpenHandCursor; }
  QString hint() const override {
    return tr("Drag the page. With any other tool, drag with the middle button, or hold Space and drag.");
  }

 private:
  std::optional<QPointF> from_;
};

}  // namespace

std::unique_ptr<PageTool> makeTool(PageToolKind kind, PageView& view) {
  switch (kind) {
    case PageToolKind::adjust:
      return std::make_unique<AdjustTool>(view);
    case PageToolKind::scale:
      return std::make_unique<ScaleTool>(view);
    case PageToolKind::drawFrame:
      return std::make_unique<DrawFrameTool>(view);
    case PageToolKind::pressColor:
      return std::make_unique<PipetteTool>(view, Stroke::press);
    case PageToolKind::releaseColor:
      return std::make_unique<PipetteTool>(view, Stroke::release);
    case PageToolKind::drawPress:
      return std::make_unique<DrawCurveTool>(view, Stroke::press);
    case PageToolKind::drawRelease:
      return std::make_unique<DrawCurveTool>(view, Stroke::release);
    case PageToolKind::maskBox:
      return std::make_unique<MaskBoxTool>(view);
    case PageToolKind::maskBrush:
      return std::make_unique<MaskBrushTool>(view);
    case PageToolKind::pan:
      return std::make_unique<PanTool>(view);
  }
  return nullptr;
}

}  // namespace detent::editor
