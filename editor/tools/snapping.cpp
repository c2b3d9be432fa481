// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/snapping.h"

#include <cmath>

namespace detent::editor {
namespace {

QPointF pixelOf(const PlotMapping& map, CurvePoint at) { return map.toPixel(at.displacement_mm, at.force_N); }

double snapDistance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

// Keeps the nearest candidate within reach.
class Nearest {
 public:
  Nearest(QPointF wanted_px, double within_px) : wanted_px_(wanted_px), reach_px_(within_px) {}
  void offer(CurvePoint at, QPointF px, SnapKind kind) {
    const double d = snapDistance(px, wanted_px_);
    if (!(d <= reach_px_)) return;
    reach_px_ = d;
    hit_ = SnapHit{at, kind};
  }
  const std::optional<SnapHit>& hit() const { return hit_; }

 private:
  QPointF wanted_px_;
  double reach_px_;
  std::optional<SnapHit> hit_;
};

// Samples the curve in steps of half a pixel around the pointer.
void offerCurve(const StrokeCurve& curve, const PlotMapping& map, QPointF wanted_px, double within_px,
                Nearest& nearest) {
  const auto offerAt = [&](double x, double force) {
    const CurvePoint at{x, force};
    nearest.offer(at, pixelOf(map, at), SnapKind::otherStroke);
  };
  for (double dx = -within_px; dx <= within_px; dx += 0.5) {
    const double x = map.toPlot(wanted_px + QPointF(dx, 0)).x();
    if (x >= curve.start_mm() && x <= curve.end_mm()) offerAt(x, curve.force_N(x));
  }
  for (const Knot& k : curve.knots()) offerAt(k.displacement_mm, k.force_N);
}

std::optional<SnapHit> gridSnap(CurvePoint wanted, const PlotMapping& map, const SnapSettings& settings) {
  const CurvePoint node{std::round(wanted.displacement_mm / settings.gridLength_mm) * settings.gridLength_mm,
                        std::round(wanted.force_N / settings.gridForce_N) * settings.gridForce_N};
  const QPointF off = pixelOf(map, node) - pixelOf(map, wanted);
  SnapHit hit{wanted, SnapKind::grid};
  const bool x = std::abs(off.x()) <= settings.within_px, y = std::abs(off.y()) <= settings.within_px;
  if (x) hit.at.displacement_mm = node.displacement_mm;
  if (y) hit.at.force_N = node.force_N;
  if (!x && !y) return {};
  return hit;
}

}  // namespace

std::optional<SnapHit> snapOf(CurvePoint wanted, const PlotMapping& map, const SnapSettings& settings,
                              const SnapSources& sources) {
  const QPointF wanted_px = pixelOf(map, wanted);
  Nearest nearest(wanted_px, settings.within_px);
  if (settings.toTracedPoints)
    for (const CurvePoint& point : sources.traced)
      nearest.offer(point, pixelOf(map, point), SnapKind::tracedPoint);
  if (settings.toOtherStroke && sources.otherStroke)
    offerCurve(*sources.otherStroke, map, wanted_px, settings.within_px, nearest);
  if (nearest.hit()) return nearest.hit();
  if (settings.toGrid) return gridSnap(wanted, map, settings);
  return {};
}

}  // namespace detent::editor
