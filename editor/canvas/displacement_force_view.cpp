// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/displacement_force_view.h"

#include <algorithm>

#include "editor/canvas/curve_path.h"

namespace detent::editor {
namespace {

// Draws curves with displacement to the right onto a plot with displacement upwards.
class Turned {
 public:
  explicit Turned(const PlotMapping& map) : map_(map) {
    along_.originX = map.originY;
    along_.originY = map.originX;
    along_.pxPerX = map.pxPerY;
    along_.pxPerY = map.pxPerX;
    along_.clip_px =
        QRectF(QPointF(map.origin_px.y() - map.clip_px.bottom(), map.origin_px.x() - map.clip_px.right()),
               QPointF(map.origin_px.y() - map.clip_px.top(), map.origin_px.x() - map.clip_px.left()));
  }
  QPointF pixel(double displacement_mm, double force_N) const {
    return map_.toPixel(force_N, displacement_mm);
  }
  QPolygonF outline(const StrokeCurve& curve, double from_mm, double to_mm) const {
    QPolygonF line = curveOutline(curve, from_mm, to_mm, along_);
    for (QPointF& p : line) p = {map_.origin_px.x() - p.y(), map_.origin_px.y() - p.x()};
    return line;
  }

 private:
  const PlotMapping& map_;
  PlotMapping along_;
};

void paintArrow(QPainter& painter, QPointF from, QPointF to) {
  painter.drawLine(from, to);
  const double way = to.y() - from.y();
  if (std::abs(way) < 14) return;
  const QPointF tip = from + 0.55 * (to - from);
  const double back = way > 0 ? -7 : 7;
  painter.drawPolyline(QPolygonF({tip + QPointF(-4, back), tip, tip + QPointF(4, back)}));
}

}  // namespace

DisplacementForceView::DisplacementForceView(ButtonDocument& document, ViewSettings& settings,
                                             const GraphCanvas& canvas, QWidget* parent)
    : UnitPlot(settings, PlotQuantity::force, PlotQuantity::displacement, parent), canvas_(canvas) {
  setObjectName(QStringLiteral("displacementForceView"));
  setAccessibleName(tr("Displacement over force"));
  setToolTip(tr(
      "The travel at each force, as a finger that sets the force feels it. Jumps appear as vertical lines."));
  const auto follow = [this, &document] {
    // A view that rescales during a drag is hard to read and slow.
    if (fitted() && isVisible() && !document.history().dragging()) fit();
    update();
  };
  connect(&document, &ButtonDocument::changed, this, follow);
  connect(&document, &ButtonDocument::activeStateChanged, this, follow);
  connect(&canvas, &GraphCanvas::selectionChanged, this, QOverload<>::of(&QWidget::update));
  fit();
}

void DisplacementForceView::showFinger(std::optional<FingerPosition> finger) {
  if (!finger && !finger_) return;
  finger_ = finger;
  update();
}

QRectF DisplacementForceView::contentRange() const {
  const ForceGraph& graph = canvas_.state().graph;
  const double low = std::min(0.0, canvas_.values().lowest_N);
  return {low, 0, canvas_.values().highest_N - low, graph.travel_mm()};
}

void DisplacementForceView::drawContent(QPainter& painter, const PlotMapping& map) const {
  painter.save();
  painter.setClipRect(map.clip_px);
  painter.setBrush(Qt::NoBrush);
  const Turned turned(map);
  const ForceGraph& graph = canvas_.state().graph;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !graph.release()) continue;
    QPen pen(stroke == Stroke::press ? colors().press : colors().release, 2);
    if (stroke == Stroke::release) pen.setDashPattern({7, 3});
    for (const Section& section : canvas_.values().of(stroke).sections) {
      painter.setPen(pen);
      if (section.kind != SectionKind::jump) {
        painter.drawPolyline(turned.outline(graph.curve(stroke), section.from_mm, section.to_mm));
        continue;
      }
      pen.setWidthF(2.6);
      painter.setPen(pen);
      paintArrow(painter, turned.pixel(section.from_mm, section.fromForce_N),
                 turned.pixel(section.to_mm, section.fromForce_N));
      pen.setWidthF(2);
    }
    painter.setPen(QPen(colors().background, 1.5));
    painter.setBrush(colors().tactilePoint);
    for (const TactilePoint& point : canvas_.values().of(stroke).tactile) {
      const QPointF at = turned.pixel(point.displacement_mm, point.force_N);
      painter.drawPolygon(
          QPolygonF({at + QPointF(0, -6), at + QPointF(6, 0), at + QPointF(0, 6), at + QPointF(-6, 0)}));
    }
    painter.setBrush(Qt::NoBrush);
  }
  if (const auto& selected = canvas_.selected()) {
    if (const auto at = placeOf(*selected, canvas_.state(), canvas_.values())) {
      painter.setPen(QPen(colors().selection, 1.5));
      painter.drawEllipse(turned.pixel(at->displacement_mm, at->force_N), 9, 9);
    }
  }
  painter.restore();
  if (finger_) {
    painter.setPen(QPen(colors().background, 2));
    painter.setBrush(finger_->stroke == Stroke::press ? colors().press : colors().release);
    painter.drawEllipse(map.inClip(turned.pixel(finger_->displacement_mm, finger_->force_N)), 7, 7);
  }
}

void DisplacementForceView::resizeEvent(QResizeEvent* event) {
  UnitPlot::resizeEvent(event);
  if (fitted()) fit();
}

}  // namespace detent::editor
