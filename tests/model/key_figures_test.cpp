// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/key_figures.h"

#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/metrics.h"
#include "model/templates.h"

using namespace detent;

namespace {

StrokeCurve straight(const std::vector<CurvePoint>& points) {
  StrokeSketch sketch{points, {}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sketch.straight.push_back(i);
  return *strokeFrom(sketch);
}

// Start 0.1 N; peak 0.6 N at 1 mm; valley 0.3 N at 2 mm; then 0.2 N/mm to 4 mm and a bottom-out to 4.1 mm.
ButtonState drawn() {
  const StrokeCurve press = straight({{0, 0.1}, {1, 0.6}, {2, 0.3}, {4, 0.7}, {4.1, 2.7}});
  const StrokeCurve release = straight({{0, 0}, {1, 0.4}, {1.5, 0.1}, {4, 0.5}, {4.1, 2.5}});
  return {"", *ForceGraph::fromCurves(press, release), 1.5, 1.25, {}};
}

void checkFigure(const KeyFigures& figures, KeyFigure figure, double expected) {
  INFO(keyFigureNames()[static_cast<std::size_t>(figure)].key);
  REQUIRE(figures[figure].has_value());
  CHECK(*figures[figure] == Approx(expected));
}

}  // namespace

TEST_CASE("key figures of a button drawn with straight lines") {
  const KeyFigures figures = keyFiguresOf(drawn());
  using enum KeyFigure;
  for (const auto& [figure, expected] :
       std::vector<std::pair<KeyFigure, double>>{{initialForce, 0.1},
                                                 {preTravel, 1.5},
                                                 {operatingForce, 0.45},
                                                 {peakForce, 0.6},
                                                 {peakTravel, 1},
                                                 {valleyForce, 0.3},
                                                 {valleyTravel, 2},
                                                 {drop, 0.3},
                                                 {snapRatio, 0.5},
                                                 {slopeToPeak, 0.5},
                                                 {slopeOfDrop, -0.3},
                                                 {slopeToBottomOut, 0.2},
                                                 {resetTravel, 1.25},
                                                 {resetForce, 0.25},
                                                 {differentialTravel, 0.25},
                                                 {overTravel, 2.6},
                                                 {bottomOutForce, 0.7},
                                                 {bottomOutTravel, 4},
                                                 {totalTravel, 4.1},
                                                 {endForce, 2.7},
                                                 {pressWork, 0.35 + 0.45 + 1 + 0.17},
                                                 {hysteresis, 1.97 - (0.2 + 0.125 + 0.75 + 0.15)}})
    checkFigure(figures, figure, expected);
}

TEST_CASE("every length counts from displacement zero, so that no part is longer than the whole") {
  ButtonState late = drawn();
  late.graph = *ForceGraph::fromCurves(straight({{0.2, 0.2}, {1, 0.6}, {2, 0.3}, {4, 0.7}, {4.1, 2.7}}), {});
  late.resetPoint_mm.reset();
  const KeyFigures figures = keyFiguresOf(late);
  using enum KeyFigure;
  checkFigure(figures, totalTravel, 4.1);
  checkFigure(figures, totalTravel, late.graph.travel_mm());
  checkFigure(figures, totalTravel, metricsOf(late).travel_mm);
  checkFigure(figures, preTravel, 1.5);
  checkFigure(figures, overTravel, 2.6);
  for (const KeyFigure part : {peakTravel, valleyTravel, bottomOutTravel, preTravel, overTravel})
    CHECK(*figures[part] <= *figures[totalTravel]);
}

TEST_CASE("a figure the button does not have is empty") {
  const KeyFigures figures =
      keyFiguresOf({"", *ForceGraph::fromCurves(straight({{0, 0.2}, {4, 0.6}}), {}), {}, {}, {}});
  for (const KeyFigure missing :
       {KeyFigure::preTravel, KeyFigure::operatingForce, KeyFigure::peakForce, KeyFigure::valleyTravel,
        KeyFigure::drop, KeyFigure::snapRatio, KeyFigure::slopeOfDrop, KeyFigure::slopeToBottomOut,
        KeyFigure::resetForce, KeyFigure::differentialTravel, KeyFigure::overTravel, KeyFigure::hysteresis})
    CHECK_FALSE(figures[missing].has_value());
  checkFigure(figures, KeyFigure::slopeToPeak, 0.1);
}

TEST_CASE("of two levels the peak is the one with the larger drop") {
  const KeyFigures figures = keyFiguresOf(twoLevelButton()->states()[0]);
  checkFigure(figures, KeyFigure::peakForce, 1.90);
  checkFigure(figures, KeyFigure::drop, 0.60);
}

// An edit that scales forces scales forces, rates and works, and leaves travels and shares alone.
TEST_CASE("key figures go with the unit they are said to have") {
  const Button button = *twoLevelButton();
  const KeyFigures before = keyFiguresOf(button.states()[0]);
  const auto twice = scaleForce(button, 2);
  REQUIRE(twice.ok());
  const KeyFigures after = keyFiguresOf(twice->states()[0]);
  std::set<std::string_view> keys;
  for (const KeyFigureName& name : keyFigureNames()) {
    INFO(name.key);
    CHECK(keys.insert(name.key).second);
    CHECK(&name - keyFigureNames().data() == static_cast<std::ptrdiff_t>(name.figure));
    REQUIRE(before[name.figure].has_value() == after[name.figure].has_value());
    if (!before[name.figure]) continue;
    const double factor = name.unit == FigureUnit::mm || name.unit == FigureUnit::share ? 1 : 2;
    CHECK(*after[name.figure] == Approx(factor * *before[name.figure]).margin(1e-9));
  }
}
