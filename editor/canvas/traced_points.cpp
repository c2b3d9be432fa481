// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/traced_points.h"

#include <cmath>

namespace detent::editor {

TracedPoints::TracedPoints(UnitPlot& plot) : QCPLayerable(&plot, QStringLiteral("main")), plot_(plot) {}

void TracedPoints::setPoints(std::vector<CurvePoint> press, std::vector<CurvePoint> release) {
  press_ = std::move(press);
  release_ = std::move(release);
}

void TracedPoints::applyDefaultAntialiasingHint(QCPPainter* painter) const {
  applyAntialiasingHint(painter, false, QCP::aeOther);
}

QRect TracedPoints::clipRect() const { return plot_.axisRect()->rect(); }

void TracedPoints::draw(QCPPainter* painter) {
  if (!shown_) return;
  const PlotMapping map = plot_.mapping();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  painter->setBrush(plot_.colors().tracedPoint);
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    QPointF last(-1e9, -1e9);
    for (const CurvePoint& point : of(stroke)) {
      const QPointF at = map.toPixel(point.displacement_mm, point.force_N);
      // Dots closer than two pixels appear as a line.
      if (!map.clip_px.contains(at) || std::hypot(at.x() - last.x(), at.y() - last.y()) < 2) continue;
      painter->drawEllipse(at, 1.6, 1.6);
      last = at;
    }
  }
  painter->restore();
}

}  // namespace detent::editor
