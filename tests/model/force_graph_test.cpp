// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/force_graph.h"

#include <limits>

#include <catch2/catch.hpp>

#include "model/button.h"

using namespace detent;

namespace {

StrokeCurve line(double from_mm, double to_mm, double fromForce_N, double toForce_N) {
  auto curve = StrokeCurve::throughPoints({{from_mm, fromForce_N}, {to_mm, toForce_N}});
  REQUIRE(curve.ok());
  return *curve;
}

ForceGraph graph() { return *ForceGraph::fromCurves(line(0, 4, 0.3, 0.8), line(0, 4, 0.2, 0.7)); }

template <class T>
void requireRefusal(const Result<T>& result, const std::string& part) {
  REQUIRE_FALSE(result.ok());
  CHECK_THAT(result.failure().sentence(), Catch::Contains(part));
  CHECK_FALSE(result.failure().remedies.empty());
}

}  // namespace

TEST_CASE("a graph without release falls back to its press") {
  const auto pressOnly = ForceGraph::fromCurves(line(0, 4, 0.3, 0.8), {});
  REQUIRE(pressOnly.ok());
  CHECK(&pressOnly->curve(Stroke::release) == &pressOnly->press());
  CHECK(pressOnly->travel_mm() == 4);
}

TEST_CASE("graphs outside the rules are refused by name") {
  requireRefusal(ForceGraph::fromCurves(line(-0.1, 4, 0, 1), {}),
                 "press curve: the press curve starts at -0.1 mm");
  requireRefusal(ForceGraph::fromCurves(line(0, 4, 0, 1.1e7), {}), "force reaches 11000000 N");
  requireRefusal(ForceGraph::fromCurves(line(0, 2e5, 0, 1), {}), "displacement reaches 200000 mm");
  requireRefusal(ForceGraph::fromCurves(line(0, 1, 0, 1), line(1, 2, 0, 1)),
                 "release curve: the release curve runs from 1 mm to 2 mm");
  // The bump between two tame knots counts as well.
  auto bump = StrokeCurve::fromKnots({{0, 0, 0, 1e8}, {1, 0, 0, 0}});
  REQUIRE(bump.ok());
  requireRefusal(ForceGraph::fromCurves(*bump, {}), "force reaches");
}

TEST_CASE("extreme but valid graphs are accepted") {
  CHECK(ForceGraph::fromCurves(line(0, 1e-6, 0, 1e-6), {}).ok());
  CHECK(ForceGraph::fromCurves(line(0, 1e5, 0, 1e6), {}).ok());
  CHECK(ForceGraph::fromCurves(line(2.5, 4, 0, 1), line(0, 4, 0, 1)).ok());
}

TEST_CASE("buttons outside the rules are refused by state and value") {
  const ButtonState plain{"", graph(), {}, {}, {}};
  requireRefusal(Button::fromStates("b", {}), "has 0 states");
  requireRefusal(Button::fromStates("b", {plain, plain, plain}), "has 3 states");
  requireRefusal(Button::fromStates("b", {plain, plain}), "same name");
  ButtonState operating = plain;
  operating.operatingPoint_mm = 5;
  requireRefusal(Button::fromStates("b", {operating}), "operating point at 5 mm lies outside");
  operating.operatingPoint_mm = std::numeric_limits<double>::quiet_NaN();
  requireRefusal(Button::fromStates("b", {operating}), "operating point at nan mm");
  ButtonState reset = plain;
  reset.resetPoint_mm = -1;
  requireRefusal(Button::fromStates("b", {reset}), "reset point at -1 mm");
  ButtonState damped = plain;
  damped.damping = {{0, 0.1}, {1, -0.1}};
  requireRefusal(Button::fromStates("b", {damped}), "damping point 2: damping -0.1");
  damped.damping = {{1, 0.1}, {1, 0.1}};
  requireRefusal(Button::fromStates("b", {damped}), "is not above that of the previous point");
  Provenance provenance;
  provenance.confidence = std::numeric_limits<double>::infinity();
  requireRefusal(Button::fromStates("b", {plain}, provenance), "provenance");
  CHECK(Button::fromStates("b", {plain}).ok());
}

TEST_CASE("a failure is one sentence of subject, place, problem and remedy") {
  const Failure failure{FailureCode::unreadableInput, "a.csv", "line 3", "is torn", "Mend it"};
  CHECK(failure.sentence() == "a.csv, line 3: is torn. Mend it.");
  CHECK(failure.exitCode() == 3);
}
