// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/unit_spread.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/templates.h"
#include "tests/model/require.h"

using namespace detent;
using detent::test::require;

namespace {

/// A unit whose peak and valley stand apart from the template's.
Button unit(double byForce_N, double by_mm) {
  TactileTemplate values;
  values.press = {{{1.3 + by_mm, 0.55 + byForce_N}, {1.9 + by_mm, 0.42 + byForce_N}}};
  values.endForce_N = 0.60 + byForce_N;
  return require(tactileButton(values));
}

const FigureSpread& spreadIn(const UnitSpread& spread, KeyFigure figure) {
  for (const FigureSpread& each : spread.states.front().figures)
    if (each.figure == figure) return each;
  FAIL("no such figure");
  return spread.states.front().figures.front();
}

std::vector<Button> scattered(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> force(0, 0.02), place(0, 0.03);
  std::vector<Button> units;
  for (std::size_t i = 0; i < count; ++i) {
    const double byForce_N = force(random);
    units.push_back(unit(byForce_N, place(random)));
  }
  return units;
}

}  // namespace

TEST_CASE("what a single unit has is not known to scatter") {
  std::vector<Button> units = scattered(3, 1);
  for (std::size_t i = 1; i < units.size(); ++i) units[i] = require(setOperatingPoint(units[i], 0, {}));
  const UnitSpread spread = require(spreadOf(units));
  const FigureSpread& operating = spreadIn(spread, KeyFigure::operatingForce);
  CHECK(operating.units == 1);
  CHECK_FALSE(operating.sd);
  CHECK(spreadIn(spread, KeyFigure::peakForce).sd);
}

TEST_CASE("units become their mean, with the spread of each figure and a band") {
  const UnitSpread spread = require(spreadOf({unit(-0.05, 0), unit(0, 0.1), unit(0.05, -0.1)}));
  const FigureSpread& peak = spreadIn(spread, KeyFigure::peakForce);
  CHECK(peak.units == 3);
  CHECK(peak.mean == Approx(0.55));
  REQUIRE(peak.sd);
  CHECK(*peak.sd == Approx(0.05));
  CHECK(peak.least == Approx(0.50));
  CHECK(peak.most == Approx(0.60));
  const KeyFigures mean = keyFiguresOf(spread.mean.states().front());
  CHECK(*mean[KeyFigure::peakForce] == Approx(0.55).margin(1e-3));
  CHECK(*mean[KeyFigure::peakTravel] == Approx(1.3).margin(0.01));
  REQUIRE(spread.states.front().press.size() == 201);
  REQUIRE(spread.states.front().release.size() == 201);
  CHECK(spread.states.front().press.front().sd_N == Approx(0).margin(1e-12));
  CHECK(spread.states.front().press.back().sd_N == Approx(0.05).margin(1e-6));
  CHECK(spread.mean.states().front().graph.press().knots().size() < 40);
}

TEST_CASE(
    "the band stands about the mean button, whose peak is not flattened where the units' peaks stand apart") {
  const UnitSpread spread = require(spreadOf({unit(0, 0), unit(0, 0.3), unit(0, -0.3)}));
  const ForceGraph& mean = spread.mean.states().front().graph;
  double highest_N = 0;
  for (const BandPoint& point : spread.states.front().press) {
    // The force before the vertical bottom-out, as for the single units.
    CHECK(point.mean_N == Approx(mean.press().forceBefore_N(point.displacement_mm)).margin(1e-12));
    if (point.displacement_mm < 1.6) highest_N = std::max(highest_N, point.mean_N);
  }
  CHECK(highest_N == Approx(0.55).margin(2e-3));
  for (const BandPoint& point : spread.states.front().release)
    CHECK(point.mean_N == Approx(mean.release()->forceBefore_N(point.displacement_mm)).margin(1e-12));
}

TEST_CASE("a unit far from the others is marked; units that scatter alike hardly ever are") {
  std::vector<Button> units = scattered(8, 1);
  units[3] = unit(0.25, 0);
  CHECK(require(spreadOf(units)).outliers == std::vector<std::size_t>{3});
  CHECK(require(spreadOf({unit(0, 0), unit(0.01, 0), unit(0.3, 0)})).outliers.empty());  // which of three?

  std::size_t marked = 0, all = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const std::size_t count = 5 + seed % 16;
    marked += require(spreadOf(scattered(count, seed))).outliers.size();
    all += count;
  }
  CAPTURE(marked, all);
  CHECK(double(marked) < 0.01 * double(all));
}

TEST_CASE("one unit, or units without a displacement in common, are no set") {
  CHECK_FALSE(spreadOf({unit(0, 0)}).ok());
  const auto far = require(StrokeCurve::throughPoints({{9, 0.1}, {10, 0.2}}));
  const auto graph = require(ForceGraph::fromCurves(far, {}));
  const auto refused = spreadOf({unit(0, 0), require(Button::fromStates("far", {{"", graph, {}, {}, {}}}))});
  REQUIRE_FALSE(refused.ok());
  CHECK_FALSE(refused.failure().remedies.empty());
}
