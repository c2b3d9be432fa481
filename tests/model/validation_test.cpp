// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/validation.h"

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/templates.h"

using namespace detent;

namespace {

Button tactile() { return *tactileButton(); }

std::vector<Rule> rulesOf(const Button& button) {
  std::vector<Rule> rules;
  for (const Warning& w : validate(button)) rules.push_back(w.rule);
  return rules;
}

Button withGraph(StrokeCurve press, std::optional<StrokeCurve> release) {
  auto graph = ForceGraph::fromCurves(std::move(press), std::move(release));
  REQUIRE(graph.ok());
  return *Button::fromStates("b", {ButtonState{"", *graph, {}, {}, {}}});
}

StrokeCurve validCurveThrough(const std::vector<CurvePoint>& points) {
  return *StrokeCurve::throughPoints(points);
}

}  // namespace

TEST_CASE("the templates give no warnings") {
  for (const auto& button :
       {linearButton(), tactileButton(), clickyButton(), twoLevelButton(), selfLockingButton()}) {
    REQUIRE(button.ok());
    for (const Warning& w : validate(*button)) FAIL_CHECK(button->name() << ": " << w.sentence());
  }
}

TEST_CASE("exchanged strokes are noticed, with the worst place") {
  const ForceGraph graph = tactile().states()[0].graph;
  const Button swapped = withGraph(*graph.release(), graph.press());
  const auto warnings = validate(swapped);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].rule == Rule::releaseAbovePress);
  CHECK(warnings[0].value > 0.1);
  CHECK(warnings[0].unit == "N");
  CHECK_THAT(warnings[0].sentence(),
             Catch::Contains("release curve, ") && Catch::Contains("above the press curve"));
}

TEST_CASE("bottom-outs a hair apart are no crossing") {
  const Button button = withGraph(validCurveThrough({{0, 0.3}, {4, 0.6}, {4, 2}}),
                                  validCurveThrough({{0, 0.2}, {3.97, 0.5}, {4, 2}}));
  CHECK(rulesOf(button) == std::vector<Rule>{});
}

TEST_CASE("each oddity is named") {
  CHECK(rulesOf(withGraph(validCurveThrough({{0, 0.3}, {4, 0.8}}), {})) == std::vector{Rule::noRelease});
  CHECK(rulesOf(withGraph(validCurveThrough({{0, 0.3}, {4, 0.8}}),
                          validCurveThrough({{0, 0.2}, {3.5, 0.6}}))) == std::vector{Rule::strokesDoNotMeet});
  CHECK(rulesOf(
            withGraph(validCurveThrough({{0, -0.3}, {4, 0.8}}), validCurveThrough({{0, -0.3}, {4, 0.8}}))) ==
        std::vector{Rule::negativeForce, Rule::negativeForce});
  CHECK(rulesOf(withGraph(validCurveThrough({{0, 0.3}, {1, 0.2}, {4, 0.8}}),
                          validCurveThrough({{0, 0.05}, {1, 0.1}, {4, 0.7}}))) ==
        std::vector{Rule::fallsAtStart});
  CHECK(rulesOf(
            withGraph(validCurveThrough({{0, 0.2}, {0.5, 1.2}, {0.8, 0.4}, {1.4, 0.8}, {1.7, 0.5}, {2, 1.5}}),
                      validCurveThrough({{0, 0.1}, {2, 1.2}}))) != std::vector<Rule>{});
  const auto reset = setResetPoint(tactile(), 0, 2.5);
  CHECK(rulesOf(*reset) == std::vector{Rule::resetBeyondOperating});
  const auto damped = setDamping(tactile(), 0, {{0, 0.1}, {5, 0.1}});
  CHECK(rulesOf(*damped) == std::vector{Rule::dampingOutsideTravel});
}

TEST_CASE("a hidden tactile point is named") {
  const Button button =
      withGraph(validCurveThrough({{0, 0.2}, {0.5, 1.2}, {0.8, 0.4}, {1.4, 0.8}, {1.7, 0.5}, {2, 1.5}}),
                validCurveThrough({{0, 0.05}, {0.8, 0.3}, {2, 0.35}, {2, 1.5}}));
  CHECK(rulesOf(button) == std::vector{Rule::hiddenTactilePoint});
}

TEST_CASE("too many knots and a doubtful import are named") {
  std::vector<CurvePoint> many;
  for (int i = 0; i <= 300; ++i) many.push_back({i * 0.01, 0.3 + i * 0.001});
  CHECK(rulesOf(withGraph(validCurveThrough(many), validCurveThrough({{0, 0.2}, {3, 0.5}}))) ==
        std::vector{Rule::manyKnots});
  Provenance provenance;
  provenance.confidence = 0.2;
  const auto doubtful = Button::fromStates("b", tactile().states(), provenance);
  REQUIRE(doubtful.ok());
  CHECK(rulesOf(*doubtful) == std::vector{Rule::lowConfidence});
}

TEST_CASE("states that do not meet are named") {
  const Button locking = *selfLockingButton();
  auto states = locking.states();
  states[1].graph = tactile().states()[0].graph;
  const auto button = Button::fromStates("b", states);
  REQUIRE(button.ok());
  CHECK(rulesOf(*button) == std::vector{Rule::statesDoNotMeet});
}
