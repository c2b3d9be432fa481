// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/blend.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "model/key_figures.h"
#include "model/templates.h"
#include "tests/model/require.h"

using namespace detent;
using detent::test::require;

namespace {

Button early() { return require(tactileButton()); }

Button late() {
  TactileTemplate values;
  values.name = "late";
  values.travel_mm = 3.4;
  values.press = {{{1.9, 0.80}, {2.3, 0.50}}};
  values.release = {{{2.0, 0.20}, {1.3, 0.45}}};
  values.endForce_N = 0.9;
  values.releaseEndForce_N = 0.85;
  values.bottomOutForce_N = 1.5;
  values.operatingPoint_mm = 2.2;
  values.resetPoint_mm = 1.5;
  return require(tactileButton(values));
}

double largestBlendDifference(const StrokeCurve& a, const StrokeCurve& b) {
  double worst = 0;
  const double end_mm = std::min(a.end_mm(), b.end_mm());
  for (int i = 0; i < 1000; ++i) {  // up to the rise, where a rounding of the travel is all of its force
    const double x = a.start_mm() + (end_mm - a.start_mm()) * (i + 0.5) / 1001;
    worst = std::max(worst, std::abs(a.force_N(x) - b.force_N(x)));
  }
  return worst;
}

double figure(const Button& button, KeyFigure which) {
  const auto value = keyFiguresOf(button.states().front())[which];
  REQUIRE(value.has_value());
  return *value;
}

}  // namespace

TEST_CASE("between two buttons: the ends are the buttons, and close to them the curves are theirs") {
  const Button a = early(), b = late();
  CHECK(require(between(a, b, 0)) == a);
  CHECK(require(between(a, b, 1)) == b);
  for (const double close : {1e-12, 1 - 1e-12}) {
    const Button near = require(between(a, b, close));
    const Button& end = close < 0.5 ? a : b;
    CHECK(largestBlendDifference(near.states()[0].graph.press(), end.states()[0].graph.press()) < 1e-9);
    CHECK(largestBlendDifference(*near.states()[0].graph.release(), *end.states()[0].graph.release()) < 1e-9);
  }
}

TEST_CASE("between two buttons: one peak and one valley, on the way from one to the other") {
  const Button a = early(), b = late();
  for (const double share : {0.1, 0.5, 0.8}) {
    CAPTURE(share);
    const Button m = require(between(a, b, share));
    const ButtonState& state = m.states().front();
    CHECK(tactilePoints(state.graph.press(), Stroke::press).size() == 1);
    CHECK(tactilePoints(*state.graph.release(), Stroke::release).size() == 1);
    for (const KeyFigure which :
         {KeyFigure::peakTravel, KeyFigure::valleyTravel, KeyFigure::preTravel, KeyFigure::resetTravel,
          KeyFigure::totalTravel, KeyFigure::bottomOutTravel}) {
      CAPTURE(int(which));
      CHECK(figure(m, which) ==
            Approx((1 - share) * figure(a, which) + share * figure(b, which)).epsilon(1e-9));
    }
    CHECK(figure(m, KeyFigure::peakForce) == Approx((1 - share) * 0.55 + share * 0.80).epsilon(0.02));
  }
}

TEST_CASE(
    "between two buttons: the work of a press lies between theirs, also of a short stiff and a long soft "
    "one") {
  LinearTemplate stiff, soft;
  stiff.travel_mm = 1, stiff.startForce_N = 0.9, stiff.endForce_N = 1.1;
  stiff.operatingPoint_mm = 0.5, stiff.resetPoint_mm = 0.4;
  soft.travel_mm = 4, soft.startForce_N = 0.2, soft.endForce_N = 0.31;
  const Button a = require(linearButton(stiff)), b = require(linearButton(soft));
  const double workA = figure(a, KeyFigure::pressWork), workB = figure(b, KeyFigure::pressWork);
  for (int i = 0; i <= 10; ++i) {
    const double work = figure(require(between(a, b, 0.1 * i)), KeyFigure::pressWork);
    CHECK(work >= std::min(workA, workB) - 1e-12);
    CHECK(work <= std::max(workA, workB) + 1e-12);
  }
}

TEST_CASE("the mean of one button many times is that button; weights count by their ratios") {
  const Button a = early(), b = late();
  const Button same = require(blend({a, a, a}, {1, 2, 3}));
  CHECK(largestBlendDifference(same.states()[0].graph.press(), a.states()[0].graph.press()) < 1e-12);
  CHECK(require(blend({a, b}, {3, 1})).states() == require(between(a, b, 0.25)).states());
  const Button first = require(blend({a, b}, {1, 0}));
  CHECK(largestBlendDifference(first.states()[0].graph.press(), a.states()[0].graph.press()) < 1e-12);
}

TEST_CASE("buttons whose features differ still have a mean: linear and tactile, with and without a release") {
  const Button a = early(), line = require(linearButton());
  const Button mean = require(between(a, line, 0.5));
  CHECK(figure(mean, KeyFigure::totalTravel) == Approx(4));
  const auto alone = require(ForceGraph::fromCurves(line.states()[0].graph.press(), {}));
  const Button pressOnly = require(Button::fromStates("p", {{"", alone, {}, {}, {}}}));
  const Button half = require(between(a, pressOnly, 0.5));
  CHECK_FALSE(half.states()[0].graph.release().has_value());
  CHECK_FALSE(half.states()[0].operatingPoint_mm.has_value());
}

TEST_CASE("no buttons, weights that do not fit, a share outside: refused with advice") {
  const Button a = early();
  for (const auto& refused : {blend({}, {}), blend({a}, {}), blend({a, a}, {0, 0}), blend({a}, {-1}),
                              between(a, a, 1.5), between(a, a, std::nan(""))}) {
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.failure().code == FailureCode::wrongUsage);
    CHECK_FALSE(refused.failure().remedies.empty());
  }
}
