// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/speed_family.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/templates.h"
#include "model/validation.h"

using namespace detent;

namespace {

ForceGraph graphOf(std::vector<CurvePoint> press, std::vector<CurvePoint> release) {
  return *ForceGraph::fromCurves(*StrokeCurve::throughPoints(press), *StrokeCurve::throughPoints(release));
}

// The faster, the stronger the press and the weaker the release.
ForceGraph graphWith(double peak_N, double release_N) {
  return graphOf({{0, 0.1}, {1, peak_N}, {2, 0.5 * peak_N}, {4, 1.0}},
                 {{0, 0.05}, {1.5, release_N}, {2, release_N - 0.05}, {4, 1.0}});
}

ButtonState stateWith(std::vector<double> speeds) {
  ButtonState state{"", graphWith(0.6, 0.3), 1.5, 1.2, {}};
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (i == 0)
      state.speed_mm_per_s = speeds[i];
    else
      state.otherSpeeds.push_back({speeds[i], graphWith(0.6 + 0.1 * static_cast<double>(i), 0.3)});
  }
  return state;
}

Result<Button> buttonWith(const ButtonState& state) { return Button::fromStates("b", {state}); }

}  // namespace

TEST_CASE("two to four speeds, each stated once and usable, the others rising") {
  CHECK(buttonWith(stateWith({})).ok());
  CHECK(buttonWith(stateWith({20, 50})).ok());
  CHECK(buttonWith(stateWith({50, 20, 100, 200})).ok());
  const auto refused = [](const std::vector<double>& speeds, const std::string& part) {
    const auto button = buttonWith(stateWith(speeds));
    INFO(part);
    REQUIRE_FALSE(button.ok());
    CHECK_THAT(button.failure().sentence(), Catch::Contains(part));
    CHECK_FALSE(button.failure().remedies.empty());
  };
  refused({20}, "gives the speed 20 mm/s, but has no graph at another speed");
  refused({20, 30, 40, 50, 60}, "has graphs at 5 speeds, which are too many. Keep two to four");
  refused({20, 20}, "has two graphs at the speed 20 mm/s");
  refused({20, 50, 40}, "speed 40 mm/s is not above the previous speed 50 mm/s");
  refused({20, 50, 50}, "is not above");
  for (const double speed :
       {0.0, -3.0, 1e6, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    refused({speed, 50}, "is not a usable speed");
    refused({50, speed}, "is not a usable speed");
  }
  ButtonState nameless = stateWith({20, 50});
  nameless.speed_mm_per_s.reset();
  CHECK_THAT(buttonWith(nameless).failure().sentence(), Catch::Contains("gives no speed for its main graph"));
}

TEST_CASE("the graphs of one button have the same strokes, travel and points") {
  const auto refused = [](const ForceGraph& other, const std::string& part) {
    ButtonState state = stateWith({20, 50});
    state.otherSpeeds[0].graph = other;
    const auto button = buttonWith(state);
    REQUIRE_FALSE(button.ok());
    CHECK_THAT(button.failure().sentence(), Catch::Contains(part));
  };
  refused(*removeRelease(graphWith(0.6, 0.3)),
          "state 1, 50 mm/s: this graph has no release, but the graph at 20 mm/s has one");
  refused(*scaleTravel(graphWith(0.6, 0.3), 1.06),
          "the press has an end at 4.24 mm, but at 4 mm in the graph of 20 mm/s; they may "
          "differ by 0.2 mm at most");
  refused(graphOf({{0, 0}, {4, 1}}, {{0.3, 0}, {4, 1}}), "the release has an end at 0.3 mm");
  ButtonState near = stateWith({20, 50});
  near.otherSpeeds[0].graph = *scaleTravel(graphWith(0.6, 0.3), 1.04);
  CHECK(buttonWith(near).ok());
  near.operatingPoint_mm = 4.0;
  near.otherSpeeds[0].graph = *scaleTravel(graphWith(0.6, 0.3), 0.97);
  CHECK_THAT(buttonWith(near).failure().sentence(),
             Catch::Contains("50 mm/s: operating point at 4 mm lies outside"));

  Button locking = *selfLockingButton();
  std::vector<ButtonState> states = locking.states();
  for (ButtonState& state : states) state.speed_mm_per_s = 20, state.otherSpeeds = {{50, state.graph}};
  CHECK(Button::fromStates("l", states).ok());
  states[1].otherSpeeds[0].speed_mm_per_s = 60;
  CHECK_THAT(Button::fromStates("l", states).failure().sentence(),
             Catch::Contains(
                 "\"locked\": the graphs of this state have other speeds than those of state \"unlocked\""));
  states[1].speed_mm_per_s = 50, states[1].otherSpeeds = {{20, states[1].graph}};
  CHECK_THAT(Button::fromStates("l", states).failure().sentence(),
             Catch::Contains("\"locked\": the main graph of this state has the speed 50 mm/s, but that of "
                             "state \"unlocked\" has 20 mm/s"));
  states[1].speed_mm_per_s.reset();
  states[1].otherSpeeds.clear();
  CHECK_FALSE(Button::fromStates("l", states).ok());
}

TEST_CASE(
    "between two speeds a force is linear in speed, beyond them it is held; at a stated one the graph is its "
    "own") {
  const Button family = *buttonWith(stateWith({50, 20, 100}));
  CHECK(speedsOf(family) == std::vector<double>{20, 50, 100});
  const ButtonState& state = family.states()[0];
  for (const auto& [speed, index] : {std::pair{20.0, 0U}, {50.0, 1U}, {100.0, 2U}, {1.0, 0U}, {1e4, 2U}}) {
    const Button one = *atSpeed(family, speed);
    CHECK(one.states()[0].graph == graphAt(state, index));
    CHECK(speedsOf(one).empty());
    CHECK(one.states()[0].operatingPoint_mm == 1.5);
  }
  const Button between = *atSpeed(family, 80);
  for (const Stroke stroke : {Stroke::press, Stroke::release})
    for (double x = 0; x <= 4; x += 0.01) {
      const double slow_N = graphAt(state, 1).curve(stroke).force_N(x),
                   fast_N = graphAt(state, 2).curve(stroke).force_N(x);
      CHECK(between.states()[0].graph.curve(stroke).force_N(x) ==
            Approx(0.4 * slow_N + 0.6 * fast_N).margin(1e-12));
    }
  CHECK(*atSpeed(*tactileButton(), 50) == *tactileButton());
  CHECK_FALSE(atSpeed(family, 0).ok());
  CHECK_FALSE(atSpeed(family, std::nan("")).ok());
}

TEST_CASE("curves that end apart are mixed with the nearer end's force, bottom-outs included") {
  ButtonState state{
      "",
      *ForceGraph::fromCurves(*StrokeCurve::fromKnots({{0, 0, 0, 1}, {4, 4, 1, 0}, {4, 9, 0, 0}}), {}),
      {},
      {},
      {}};
  state.speed_mm_per_s = 10;
  state.otherSpeeds = {
      {30, *ForceGraph::fromCurves(*StrokeCurve::fromKnots({{0.1, 0, 0, 2}, {3.9, 7.6, 2, 2}}), {})}};
  const auto mixed = atSpeed(*buttonWith(state), 20);
  REQUIRE(mixed.ok());
  const StrokeCurve& press = mixed->states()[0].graph.press();
  CHECK(press.force_N(0.05) == Approx(0.025));
  CHECK(press.force_N(2) == Approx(0.5 * (2 + 3.8)));
  CHECK(press.force_N(3.95) == Approx(0.5 * (3.95 + 7.6)));
  CHECK(press.forceBefore_N(4) == Approx(0.5 * (4 + 7.6)));
  CHECK(press.force_N(4) == Approx(0.5 * (9 + 7.6)));
}

TEST_CASE("a family is made of buttons, in any order of their speeds, and any of them brought forward") {
  const Button slow = *buttonWith(stateWith({})), fast = *scaleForce(slow, 1.4),
               middle = *scaleForce(slow, 1.2);
  const Button family = *familyOf({middle, slow, fast}, {50, 10, 200});
  CHECK(speedsOf(family) == std::vector<double>{10, 50, 200});
  CHECK(family.states()[0].graph == middle.states()[0].graph);
  CHECK(family.states()[0].speed_mm_per_s == 50);
  for (const std::size_t i : {0U, 1U, 2U}) {
    const Button other = broughtForward(family, i);
    CHECK(other.states()[0].speed_mm_per_s == speedsOf(family)[i]);
    CHECK(speedsOf(other) == speedsOf(family));
    CHECK(broughtForward(other, 1) == family);
    for (const double speed : {5.0, 10.0, 33.0, 120.0})
      CHECK(*atSpeed(other, speed) == *atSpeed(family, speed));
  }
  CHECK(broughtForward(slow, 0) == slow);
  CHECK_FALSE(familyOf({slow}, {10}).ok());
  CHECK_FALSE(familyOf({slow, fast}, {10}).ok());
  CHECK_FALSE(familyOf({slow, fast}, {10, 10}).ok());
  CHECK_FALSE(familyOf({slow, *selfLockingButton()}, {10, 20}).ok());
}

TEST_CASE("scaling a button scales its graphs at all speeds") {
  const Button family = *buttonWith(stateWith({50, 20, 100}));
  const Button longer = *scaleTravel(family, 2), stronger = *scaleForce(family, 3);
  for (const std::size_t i : {0U, 1U, 2U}) {
    CHECK(graphAt(longer.states()[0], i).travel_mm() == Approx(8));
    CHECK(graphAt(stronger.states()[0], i).press().force_N(1) ==
          Approx(3 * graphAt(family.states()[0], i).press().force_N(1)));
  }
}

TEST_CASE("a release above the press of another speed is reported, with both speeds") {
  ButtonState state = stateWith({20, 100});
  const auto described = [&] {
    std::vector<std::string> sentences;
    for (const Warning& w : validate(*buttonWith(state)))
      if (w.rule == Rule::speedsGiveEnergy) sentences.push_back(w.sentence());
    return sentences;
  };
  CHECK(described().empty());
  state.otherSpeeds[0].graph = graphWith(0.25, 0.1);
  REQUIRE(described().size() == 1);
  CHECK_THAT(described()[0], Catch::StartsWith("release curve at 20 mm/s") &&
                                 Catch::Contains("above the press curve at 100 mm/s"));
  state.otherSpeeds[0].graph = graphWith(0.6, 0.55);  // the release of this speed is above its own press
  REQUIRE(described().size() == 1);
  CHECK_THAT(described()[0], Catch::Contains("release curve at 100 mm/s"));
}
