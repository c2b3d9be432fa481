// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/metrics.h"

#include <algorithm>
#include <tuple>

#include "model/known_bottom_out.h"

namespace detent {
namespace {

// Returns the extremum between the tactile point and the next one (or the end of the jump): the lowest of a
// press, the highest of a release. If the force never turns back, the end.
std::optional<CurvePoint> followingExtremum(const StrokeCurve& curve, Stroke stroke,
                                            const std::vector<CurvePoint>& extrema, double from_mm,
                                            double to_mm) {
  std::optional<CurvePoint> best;
  const auto consider = [&](double x, double force) {
    const bool between = stroke == Stroke::press ? x > from_mm && x <= to_mm : x < from_mm && x >= to_mm;
    if (!between) return;
    if (!best || (stroke == Stroke::press ? force < best->force_N : force > best->force_N)) best = {x, force};
  };
  for (const CurvePoint& p : extrema) consider(p.displacement_mm, p.force_N);
  const Knot& end = stroke == Stroke::press ? curve.knots().back() : curve.knots().front();
  consider(end.displacement_mm, end.force_N);
  return best;
}

std::vector<TactileEvent> tactileEvents(const StrokeCurve& curve, Stroke stroke, const StrokeMetrics& metrics,
                                        const SectionSettings& settings) {
  const std::vector<TactilePoint> points = tactilePoints(curve, stroke, metrics.bottomOut, settings);
  const std::vector<CurvePoint> extrema = stroke == Stroke::press ? curve.localMinima() : curve.localMaxima();
  std::vector<TactileEvent> events;
  for (std::size_t i = 0; i < points.size(); ++i) {
    TactileEvent event;
    event.point = points[i];
    const double end_mm = stroke == Stroke::press ? curve.end_mm() : curve.start_mm();
    const double stop_mm = i + 1 < points.size() ? points[i + 1].displacement_mm : end_mm;
    event.following = followingExtremum(curve, stroke, extrema, points[i].displacement_mm, stop_mm);
    if (stroke == Stroke::press && event.following && points[i].force_N > 0)
      event.snapRatio = (points[i].force_N - event.following->force_N) / points[i].force_N;
    for (const Section& s : metrics.sections) {
      if (s.kind != SectionKind::jump || s.from_mm != points[i].displacement_mm) continue;
      event.jump = s;
      event.jumpArea_mJ = jumpArea_mJ(curve, s);
    }
    events.push_back(event);
  }
  return events;
}

std::optional<CurvePoint> pointOn(const StrokeCurve& curve, std::optional<double> displacement_mm) {
  if (!displacement_mm) return {};
  return CurvePoint{*displacement_mm, curve.force_N(*displacement_mm)};
}

}  // namespace

StrokeMetrics metricsOf(const StrokeCurve& curve, Stroke stroke, const SectionSettings& settings) {
  StrokeMetrics metrics;
  metrics.bottomOut = bottomOutOf(curve, settings);
  metrics.sections = sectionsOf(curve, stroke, metrics.bottomOut, settings);
  metrics.tactile = tactileEvents(curve, stroke, metrics, settings);
  metrics.startForce_N = curve.knots().front().force_N;
  metrics.endForce_N = curve.knots().back().force_N;
  std::tie(metrics.minForce_N, metrics.maxForce_N) = curve.forceRange_N();
  metrics.work_mJ = curve.area_mJ(curve.start_mm(), curve.end_mm());
  return metrics;
}

StateMetrics metricsOf(const ButtonState& state, const SectionSettings& settings) {
  StateMetrics metrics;
  const StrokeCurve& press = state.graph.press();
  metrics.travel_mm = state.graph.travel_mm();
  metrics.press = metricsOf(press, Stroke::press, settings);
  if (const auto& release = state.graph.release()) {
    metrics.release = metricsOf(*release, Stroke::release, settings);
    const double from = std::max(press.start_mm(), release->start_mm());
    const double to = std::min(press.end_mm(), release->end_mm());
    metrics.hysteresisArea_mJ = press.area_mJ(from, to) - release->area_mJ(from, to);
  }
  metrics.operatingPoint = pointOn(press, state.operatingPoint_mm);
  metrics.resetPoint = pointOn(state.graph.curve(Stroke::release), state.resetPoint_mm);
  return metrics;
}

}  // namespace detent
