// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/metrics.h"

#include <catch2/catch.hpp>

#include "model/templates.h"

using namespace detent;

namespace {

StrokeCurve straightMetric(const std::vector<CurvePoint>& points) {
  StrokeSketch sketch{points, {}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sketch.straight.push_back(i);
  return *strokeFrom(sketch);
}

}  // namespace

TEST_CASE("figures of a button drawn with straight lines") {
  const StrokeCurve press = straightMetric({{0, 0}, {1, 0.6}, {2, 0.3}, {4, 0.9}});
  const StrokeCurve release = straightMetric({{0, 0}, {1, 0.4}, {1.5, 0.1}, {4, 0.6}});
  const ButtonState state{"", *ForceGraph::fromCurves(press, release), 1.5, 1.25, {}};
  const StateMetrics m = metricsOf(state);
  CHECK(m.travel_mm == 4);
  REQUIRE(m.press.tactile.size() == 1);
  CHECK(m.press.tactile[0].point.force_N == 0.6);
  CHECK(m.press.tactile[0].following->force_N == 0.3);
  CHECK(*m.press.tactile[0].snapRatio == Approx(0.5));
  CHECK(m.press.tactile[0].jump->to_mm == Approx(3));
  CHECK(m.press.tactile[0].jumpArea_mJ == Approx(0.3));
  CHECK(m.press.work_mJ == Approx(0.3 + 0.45 + 1.2));
  REQUIRE(m.release.has_value());
  REQUIRE(m.release->tactile.size() == 1);
  CHECK(m.release->tactile[0].point.displacement_mm == 1.5);
  CHECK(m.release->tactile[0].following->force_N == 0.4);
  CHECK_FALSE(m.release->tactile[0].snapRatio.has_value());
  CHECK(*m.hysteresisArea_mJ == Approx(1.95 - (0.2 + 0.125 + 0.875)));
  CHECK(m.operatingPoint->force_N == Approx(0.45));
  CHECK(m.resetPoint->force_N == Approx(0.25));
}

TEST_CASE("two levels have two snap ratios; a linear button has none") {
  const StateMetrics two = metricsOf(twoLevelButton()->states()[0]);
  REQUIRE(two.press.tactile.size() == 2);
  CHECK(*two.press.tactile[0].snapRatio == Approx((0.80 - 0.62) / 0.80));
  CHECK(*two.press.tactile[1].snapRatio == Approx((1.90 - 1.30) / 1.90));
  CHECK(metricsOf(linearButton()->states()[0]).press.tactile.empty());
}

TEST_CASE("a force that never turns back has its end as valley") {
  const StrokeMetrics m = metricsOf(straightMetric({{0, 0}, {1, 0.6}, {4, 0.2}}), Stroke::press);
  REQUIRE(m.tactile.size() == 1);
  CHECK(m.tactile[0].following == CurvePoint{4, 0.2});
}

TEST_CASE("hysteresis counts only where both strokes are; a missing release has none") {
  const StrokeCurve press = straightMetric({{0, 1}, {4, 1}});
  const ButtonState partly{
      "", *ForceGraph::fromCurves(press, straightMetric({{1, 0.5}, {3, 0.5}})), {}, {}, {}};
  CHECK(*metricsOf(partly).hysteresisArea_mJ == Approx(1));
  const ButtonState pressOnly{"", *ForceGraph::fromCurves(press, {}), {}, {}, {}};
  CHECK_FALSE(metricsOf(pressOnly).hysteresisArea_mJ.has_value());
}
