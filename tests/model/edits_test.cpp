// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "model/metrics.h"
#include "model/templates.h"
#include "tests/model/property.h"
#include "tests/model/random_curves.h"
#include "tests/model/require.h"

using namespace detent;
using detent::test::require;
using detent::tests::anyCurve;
using detent::tests::between;
using detent::tests::holdsAlways;

namespace {

StrokeCurve curveThrough(std::vector<CurvePoint> points) {
  auto curve = StrokeCurve::throughPoints(points);
  REQUIRE(curve.ok());
  return *curve;
}

StrokeCurve tactileCurve() {
  return curveThrough({{0, 0.3}, {0.5, 0.5}, {1, 0.6}, {1.6, 0.4}, {3.9, 0.7}, {3.9, 1.5}});
}

template <class T>
void requireEditRefusal(const Result<T>& result, const std::string& part) {
  REQUIRE_FALSE(result.ok());
  CHECK_THAT(result.failure().sentence(), Catch::Contains(part));
  CHECK_FALSE(result.failure().remedies.empty());
}

double largestDifference(const StrokeCurve& a, const StrokeCurve& b) {
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = a.start_mm() + a.travel_mm() * i / 1000;
    worst = std::max(worst, std::abs(a.force_N(x) - b.force_N(x)));
  }
  return worst;
}

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a valley moves with its flanks and stays the valley") {
  const StrokeCurve curve = tactileCurve();
  const CurvePoint valley = curve.localMinima().front();
  const StrokeCurve moved = require(moveTurn(curve, valley, {1.7, 0.35}));
  REQUIRE(moved.localMinima().size() == 1);
  CHECK(moved.localMinima().front() == CurvePoint{1.7, 0.35});
  // The tactile point and the ends stay.
  CHECK(moved.localMaxima() == curve.localMaxima());
  CHECK(moved.knots().front() == curve.knots().front());
  CHECK(moved.knots().back() == curve.knots().back());
  requireEditRefusal(moveTurn(curve, valley, {1.7, 0.65}), "would no longer be a peak or valley");
  requireEditRefusal(moveTurn(curve, valley, {0.9, 0.35}), "it must stay between");
  requireEditRefusal(moveTurn(curve, {1.65, 0.4}, {1.7, 0.35}),
                     "is neither a peak nor a valley of the curve");
}

TEST_CASE("knots move between their neighbours and keep their slopes") {
  const StrokeCurve moved = require(moveKnot(tactileCurve(), 2, {1.2, 0.65}));
  CHECK(moved.force_N(1.2) == 0.65);
  CHECK(moved.knots()[2].slopeAfter_N_per_mm == tactileCurve().knots()[2].slopeAfter_N_per_mm);
  requireEditRefusal(moveKnot(tactileCurve(), 2, {1.7, 0.6}), "its neighbour at 1.6 mm");
  requireEditRefusal(moveKnot(tactileCurve(), 9, {1, 1}), "has no point 10, because it has only 6 points");
  requireEditRefusal(moveKnot(tactileCurve(), 2, {notANumber, 0.6}), "not a usable number");
}

TEST_CASE("slopes, corners and smooth knots") {
  StrokeCurve curve = require(setSlopeAfter(tactileCurve(), 2, -1));
  CHECK(isCorner(curve, 2));
  curve = require(setSlope(curve, 2, 0.25));
  CHECK_FALSE(isCorner(curve, 2));
  CHECK(curve.slope_N_per_mm(1) == 0.25);
  curve = require(makeCorner(curve, 2));
  CHECK(curve.slopeBefore_N_per_mm(1) == Approx(0.2));
  CHECK(curve.slope_N_per_mm(1) == Approx(-1.0 / 3));
  curve = require(makeSmooth(curve, 2));
  CHECK(curve.slope_N_per_mm(1) == 0);  // an extremum
  curve = require(makeSmooth(curve, 1));
  CHECK(curve.slope_N_per_mm(0.5) > 0);
  CHECK(isCorner(curve, 4));  // a vertical rise begins there
  requireEditRefusal(setSlope(curve, 0, notANumber), "not a usable number");
}

TEST_CASE("inserting a knot changes no shape, removing it restores the knots") {
  holdsAlways("insertKnot", [] {
    const StrokeCurve curve = anyCurve();
    const double x = curve.start_mm() + between(0.001, 0.999) * curve.travel_mm();
    const auto inserted = insertKnot(curve, x);
    if (!inserted) return;  // a knot stood there
    RC_ASSERT(inserted->knots().size() == curve.knots().size() + 1);
    RC_ASSERT(largestDifference(curve, *inserted) < 1e-12);
    std::size_t index = 0;
    while (inserted->knots()[index].displacement_mm != x) ++index;
    RC_ASSERT(removeKnot(*inserted, index).value() == curve);
  });
  requireEditRefusal(insertKnot(tactileCurve(), 1), "already is a curve point at 1 mm");
  requireEditRefusal(insertKnot(tactileCurve(), 0), "no point can be added");
  requireEditRefusal(insertKnot(tactileCurve(), notANumber), "no point can be added");
  requireEditRefusal(removeKnot(curveThrough({{0, 0}, {1, 1}}), 0), "needs 2 points");
}

// The start is lifted by 0.35 N; with its slope of 0.81 N/mm kept, the force would reach 0.86 N at 0.4 mm.
TEST_CASE("a moved knot makes no peak beside it") {
  const StrokeCurve curve = require(StrokeCurve::fromKnots(
      {{0, 0.35, 0.81, 0.81}, {1.2, 0.75, 0, 0}, {1.6, 0.5, 0, 0}, {3, 0.7, 0.2, 0.2}}));
  const StrokeCurve moved = require(moveKnot(curve, 0, {0, 0.7}));
  REQUIRE(moved.localMaxima().size() == 1);
  CHECK(moved.localMaxima().front() == CurvePoint{1.2, 0.75});
  CHECK(moved.knots()[0].slopeAfter_N_per_mm == Approx(3 * 0.05 / 1.2));
  CHECK(std::equal(moved.knots().begin() + 1, moved.knots().end(), curve.knots().begin() + 1));
  // A smooth knot stays smooth, and what had a turn before may keep it.
  const StrokeCurve steep = require(StrokeCurve::fromKnots({{0, 0, 1, 1}, {1, 1, 1, 1}, {2, 2, 1, 1}}));
  const StrokeCurve low = require(moveKnot(steep, 1, {1, 0.1}));
  CHECK(low.knots()[1].slopeBefore_N_per_mm == low.knots()[1].slopeAfter_N_per_mm);
  CHECK(low.localMaxima().empty());
  CHECK(low.localMinima().empty());
  const StrokeCurve turning = require(StrokeCurve::fromKnots({{0, 0.5, 2, 2}, {2, 0.6, 0, 0}}));
  CHECK(require(moveKnot(turning, 0, {0, 0.55})).knots()[0].slopeAfter_N_per_mm == 2);
}

TEST_CASE("several knots are put at once, in their order, and keep their slopes") {
  const StrokeCurve curve = tactileCurve();
  const StrokeCurve moved = require(placeKnots(curve, {{1, {0.6, 0.55}}, {2, {1.1, 0.65}}}));
  CHECK(moved.knots()[1].displacement_mm == 0.6);
  CHECK(moved.knots()[2].force_N == 0.65);
  CHECK(moved.knots()[2].slopeAfter_N_per_mm == curve.knots()[2].slopeAfter_N_per_mm);
  CHECK(moved.knots()[3] == curve.knots()[3]);
  CHECK(require(placeKnots(curve, {})) == curve);
  // One at a time the first would pass the second.
  CHECK(placeKnots(curve, {{1, {1.2, 0.55}}, {2, {1.4, 0.6}}}).ok());
  requireEditRefusal(placeKnots(curve, {{1, {1.2, 0.55}}}), "before curve point 2");
  requireEditRefusal(placeKnots(curve, {{9, {1, 1}}}), "no point 10");
  CHECK_FALSE(placeKnots(curve, {{1, {notANumber, 1}}}).ok());
}

TEST_CASE("several knots are removed at once") {
  const StrokeCurve curve = tactileCurve();
  const StrokeCurve left = require(removeKnots(curve, {3, 1, 3}));
  REQUIRE(left.knots().size() == curve.knots().size() - 2);
  CHECK(left.knots()[1] == curve.knots()[2]);
  CHECK(require(removeKnots(curve, {})) == curve);
  requireEditRefusal(removeKnots(curve, {0, 1, 2, 3, 4}), "needs 2 points");
  requireEditRefusal(removeKnots(curve, {6}), "no point 7");
}

TEST_CASE("a stretch taken out and put back changes no shape") {
  holdsAlways("any curve, any two places", [] {
    const StrokeCurve curve = anyCurve();
    const double a = curve.start_mm() + curve.travel_mm() * between(0.0, 0.45);
    const double b = curve.start_mm() + curve.travel_mm() * between(0.55, 1.0);
    const auto stretch = stretchOf(curve, a, b);
    if (!stretch) return;  // an end too close to a knot for a slope
    const auto back = putStretch(curve, *stretch);
    RC_ASSERT(back.ok());
    const auto [low, high] = curve.forceRange_N();
    RC_ASSERT(largestDifference(curve, *back) <= 1e-9 * std::max({1.0, std::abs(low), std::abs(high)}));
  });
  const StrokeCurve curve = tactileCurve();
  const auto stretch = require(stretchOf(curve, 0.7, 1.3));
  CHECK(stretch.size() == 3);
  CHECK(require(putStretch(curve, {Knot{5, 2, 1, 1}})).end_mm() == 5);
  requireEditRefusal(stretchOf(curve, 1, 1), "has no part");
  requireEditRefusal(stretchOf(curve, -1, 1), "has no part");
  requireEditRefusal(putStretch(curve, {}), "no points");
}

TEST_CASE("a tactile point goes exactly where it is moved and stays the only one") {
  const StrokeCurve curve = tactileCurve();
  for (CurvePoint to :
       {CurvePoint{1.3, 0.9}, CurvePoint{0.2, 0.5}, CurvePoint{1.0, 0.62}, CurvePoint{1.59, 0.45}}) {
    const StrokeCurve moved = require(moveTactilePoint(curve, Stroke::press, 0, to));
    const auto points = tactilePoints(moved, Stroke::press);
    REQUIRE(points.size() == 1);
    CHECK(points[0].displacement_mm == to.displacement_mm);
    CHECK(points[0].force_N == to.force_N);
    CHECK(moved.force_N(3.0) == Approx(curve.force_N(3.0)).epsilon(1e-12));
  }
  requireEditRefusal(moveTactilePoint(curve, Stroke::press, 0, {1.7, 0.6}),
                     "it must stay between 0 mm and 1.6 mm");
  requireEditRefusal(moveTactilePoint(curve, Stroke::press, 0, {1, 0.35}),
                     "with the force 0.35 N, the point would no longer be a peak or valley");
  requireEditRefusal(moveTactilePoint(curve, Stroke::press, 1, {1, 0.6}),
                     "has no tactile point 2, because it has only 1");
  requireEditRefusal(moveTactilePoint(curve, Stroke::press, 0, {notANumber, 0.6}), "cannot move to nan mm");
}

TEST_CASE("a tactile point between knots is moved as well, and of a release too") {
  auto hump = StrokeCurve::fromKnots({{0, 0, 0, 3}, {2, 0.2, -1, 1}, {4, 1, 0.4, 0}});
  REQUIRE(hump.ok());
  const StrokeCurve moved = require(moveTactilePoint(*hump, Stroke::press, 0, {0.9, 1.4}));
  CHECK(tactilePoints(moved, Stroke::press)[0].displacement_mm == 0.9);
  CHECK(tactilePoints(moved, Stroke::press)[0].force_N == 1.4);
  const StrokeCurve release = require(moveTactilePoint(tactileCurve(), Stroke::release, 0, {1.9, 0.2}));
  CHECK(tactilePoints(release, Stroke::release)[0].displacement_mm == 1.9);
}

TEST_CASE(
    "a tactile point on top of a vertical piece is drawn away from it, whatever the piece's inner slopes") {
  const auto withBottomOut =
      StrokeCurve::fromKnots({{0, 0, 7, 9}, {0, 0.6, -5, 0}, {2, 0.4, 0, 0.3}, {3, 1, 0.3, 0}});
  REQUIRE(withBottomOut.ok());
  REQUIRE(tactilePoints(*withBottomOut, Stroke::press).size() == 1);
  const StrokeCurve moved = require(moveTactilePoint(*withBottomOut, Stroke::press, 0, {0.5, 0.8}));
  CHECK(moved.force_N(0) == 0);
  const auto points = tactilePoints(moved, Stroke::press);
  REQUIRE(points.size() == 1);
  CHECK(points[0].displacement_mm == 0.5);
  CHECK(points[0].force_N == 0.8);
}

TEST_CASE("the lower end of a vertical piece ends the flanks beside it") {
  // A rise up to almost the height of the tactile point before it: stretched from top to top, its lower end
  // would fly 13 N away.
  const auto curve = StrokeCurve::fromKnots(
      {{0, 0, 4, 4}, {1, 0.41, 0, 0}, {2, 0.3, -0.2, 0}, {2, 0.40999, 0, -0.3}, {3, 0, -0.4, -0.4}});
  REQUIRE(curve.ok());
  const auto points = tactilePoints(*curve, Stroke::press);
  REQUIRE(points.size() == 2);
  const StrokeCurve first = require(moveTactilePoint(*curve, Stroke::press, 0, {1, 0.45}));
  CHECK(first.forceBefore_N(2) == 0.3);
  CHECK(first.force_N(2) == 0.40999);
  const StrokeCurve second = require(moveTactilePoint(*curve, Stroke::press, 1, {2, 0.5}));
  CHECK(second.forceBefore_N(2) == 0.3);
  CHECK(second.force_N(2) == 0.5);
  CHECK(second.slopeBefore_N_per_mm(2) == curve->slopeBefore_N_per_mm(2));
  CHECK(second.force_N(1.5) == curve->force_N(1.5));
}

TEST_CASE("any tactile point of any curve can be moved a little") {
  holdsAlways("moveTactilePoint", [] {
    const StrokeCurve curve = anyCurve();
    for (Stroke stroke : {Stroke::press, Stroke::release}) {
      const auto points = tactilePoints(curve, stroke);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double outwards = (stroke == Stroke::press ? 1 : -1) * 0.01;
        const CurvePoint to{points[i].displacement_mm, points[i].force_N + outwards};
        const auto moved = moveTactilePoint(curve, stroke, i, to);
        if (!moved) continue;  // a neighbouring turn of the same height, refused by name
        // The point is an extremum, or the end of a level top of which half was fixed. The whole curve
        // decides which extrema are tactile points, and where the bottom-out begins.
        RC_ASSERT(std::abs(moved->force_N(to.displacement_mm) - to.force_N) < 1e-12 ||
                  std::abs(moved->forceBefore_N(to.displacement_mm) - to.force_N) < 1e-12);
        const auto turns = stroke == Stroke::press ? moved->localMaxima() : moved->localMinima();
        RC_ASSERT(std::any_of(turns.begin(), turns.end(),
                              [&](CurvePoint p) { return std::abs(p.force_N - to.force_N) < 1e-12; }));
      }
    }
  });
}

TEST_CASE("the snap ratio becomes the requested one") {
  for (double ratio : {0.05, 0.5, 0.9, 1.2}) {
    const StrokeCurve snapped = require(setSnapRatio(tactileCurve(), 0, ratio));
    const auto metrics = metricsOf(snapped, Stroke::press);
    REQUIRE(metrics.tactile.size() == 1);
    CHECK(*metrics.tactile[0].snapRatio == Approx(ratio));
    CHECK(metrics.tactile[0].point.force_N == 0.6);
  }
  requireEditRefusal(setSnapRatio(tactileCurve(), 0, 0), "snap ratio of 0");
  requireEditRefusal(setSnapRatio(tactileCurve(), 3, 0.5), "has no tactile point 4");
}

TEST_CASE("a section moves as a whole, its neighbours stretch") {
  const StrokeCurve curve = tactileCurve();
  const auto before = sectionsOf(curve, Stroke::press);
  const StrokeCurve moved = require(moveSection(curve, Stroke::press, 1, 0.1, 0.05));
  const auto after = sectionsOf(moved, Stroke::press);
  REQUIRE(after.size() == before.size());
  CHECK(after[1].from_mm == Approx(before[1].from_mm + 0.1));
  CHECK(after[1].fromForce_N == Approx(before[1].fromForce_N + 0.05));
  CHECK(moved.force_N(1.7) == Approx(curve.force_N(1.6) + 0.05));
  // A quarter of the way up the neighbour: displacement by a quarter, force by 3s² - 2s³.
  const StrokeCurve quarter =
      require(moveSection(require(insertKnot(curve, 0.25)), Stroke::press, 1, 0.1, 0.05));
  CHECK(quarter.knots()[1].displacement_mm == Approx(0.275));
  CHECK(quarter.knots()[1].force_N == Approx(curve.force_N(0.25) + 0.05 * 0.15625));
  CHECK(moved.start_mm() == 0);
  CHECK(moved.knots().front().force_N == curve.knots().front().force_N);
  CHECK(moved.end_mm() == curve.end_mm());
  requireEditRefusal(moveSection(curve, Stroke::press, 1, -1.5, 0), "the neighbouring section ends at 0 mm");
  requireEditRefusal(moveSection(curve, Stroke::press, 8, 0, 0), "has no section 9");
  requireEditRefusal(moveSection(curve, Stroke::press, 1, notANumber, 0), "not a usable number");
}

TEST_CASE("moving a release's section moves the same stretch") {
  const StrokeCurve curve = curveThrough({{0, 0.3}, {0.8, 0.45}, {1.5, 0.2}, {3.9, 0.65}});
  const StrokeCurve moved = require(moveSection(curve, Stroke::release, 0, 0.2, 0.1));
  CHECK(tactilePoints(moved, Stroke::release)[0].displacement_mm == Approx(1.7));
  CHECK(moved.end_mm() == Approx(4.1));
}

TEST_CASE("jumps are added and removed on both strokes") {
  const StrokeCurve line = curveThrough({{0, 0.3}, {4, 0.8}});
  for (Stroke stroke : {Stroke::press, Stroke::release}) {
    const StrokeCurve jumping = require(addJump(line, stroke, {2, 0.6, 0.2}));
    const auto points = tactilePoints(jumping, stroke);
    REQUIRE(points.size() == 1);
    CHECK(points[0].displacement_mm == 2);
    CHECK(points[0].force_N == Approx(0.55));
    CHECK(largestDifference(line, jumping) == Approx(0.2).margin(0.05));
    const StrokeCurve smooth = require(removeJump(jumping, stroke, 0));
    CHECK(tactilePoints(smooth, stroke).empty());
    CHECK(smooth.monotoneStretches().size() == 1);
  }
  const StrokeCurve two =
      require(addJump(require(addJump(line, Stroke::press, {1, 0.4, 0.2})), Stroke::press, {2.5, 0.4, 0.2}));
  CHECK(tactilePoints(two, Stroke::press).size() == 2);
  requireEditRefusal(addJump(line, Stroke::press, {3.8, 0.6, 0.2}), "leaves the curve");
  requireEditRefusal(addJump(line, Stroke::press, {2, -1, 0.2}), "has the width -1 mm");
  requireEditRefusal(addJump(line, Stroke::press, {2, 0.6, notANumber}), "drop nan N");
  requireEditRefusal(addJump(curveThrough({{0, 1}, {4, 0}}), Stroke::press, {2, 0.6, 0.2}), "does not rise");
}

TEST_CASE("a linear button keeps its bottom-out") {
  const StrokeCurve line = require(makeLinear(tactileCurve()));
  CHECK(tactilePoints(line, Stroke::press).empty());
  CHECK(line.knots().size() == 3);
  CHECK(line.force_N(1.95) == Approx(0.5));
  CHECK(bottomOutOf(line).isSteep);
}

TEST_CASE("mirroring: release lies below press by the hysteresis and never below 0") {
  const ForceGraph graph = require(ForceGraph::fromCurves(tactileCurve(), {}));
  const ForceGraph mirrored = require(mirrorPressToRelease(graph, 0.1));
  for (int i = 0; i <= 100; ++i) {
    const double x = 3.89 * i / 100;
    CHECK(mirrored.release()->force_N(x) == Approx(graph.press().force_N(x) - 0.1));
  }
  const ForceGraph weak = require(ForceGraph::fromCurves(curveThrough({{0, 0}, {1, 0.1}, {4, 1}}), {}));
  const ForceGraph low = require(mirrorPressToRelease(weak, 0.2));
  CHECK(low.release()->forceRange_N().first >= 0);
  CHECK(low.release()->force_N(4) == Approx(0.8));
  CHECK(require(mirrorPressToRelease(graph, 0)).release() == graph.press());
  requireEditRefusal(mirrorPressToRelease(graph, -1), "hysteresis");
  CHECK_FALSE(require(removeRelease(mirrored)).release().has_value());
  requireEditRefusal(editStroke(graph, Stroke::release, [](const StrokeCurve& c) { return makeLinear(c); }),
                     "there is no release curve");
}

TEST_CASE("scaling scales everything that has the unit") {
  TactileTemplate values;
  Button button = require(tactileButton(values));
  button = require(setDamping(button, 0, {{0, 0.1}, {4, 0.2}}));
  const Button strong = require(scaleForce(button, 2));
  CHECK(strong.states()[0].graph.press().force_N(1.3) == 1.1);
  CHECK(strong.states()[0].damping[1].damping_Ns_per_mm == 0.4);
  const Button scaled = require(scaleTravel(button, 0.5));
  const ButtonState& state = scaled.states()[0];
  CHECK(state.graph.travel_mm() == 2);
  CHECK(*state.operatingPoint_mm == 1);
  CHECK(state.damping[1].displacement_mm == 2);
  CHECK(state.graph.press().area_mJ(0, 2) == Approx(button.states()[0].graph.press().area_mJ(0, 4) / 2));
  CHECK(require(scaleForce(strong, 0.5)) == button);
  CHECK(require(scaleTravel(scaled, 2)) == button);
  for (double bad : {0.0, -1.0, notANumber, HUGE_VAL}) {
    requireEditRefusal(scaleForce(button, bad), "not a number above 0");
    requireEditRefusal(scaleTravel(button, bad), "not a number above 0");
  }
  requireEditRefusal(scaleForce(button, 1e9), "beyond the limit");
}

TEST_CASE("edits of a button reach its state, and keep its rules") {
  const Button button = require(selfLockingButton());
  const Button renamed = require(rename(button, "x"));
  CHECK(renamed.name() == "x");
  CHECK(renamed.states() == button.states());
  const Button edited = require(editGraph(button, 1, [](const ForceGraph& g) { return scaleForce(g, 2); }));
  CHECK(edited.states()[0] == button.states()[0]);
  CHECK_FALSE(edited.states()[1] == button.states()[1]);
  CHECK(*require(setOperatingPoint(button, 0, 3)).states()[0].operatingPoint_mm == 3);
  CHECK_FALSE(require(setResetPoint(button, 0, {})).states()[0].resetPoint_mm.has_value());
  requireEditRefusal(setOperatingPoint(button, 0, 9), "operating point at 9 mm");
  requireEditRefusal(editGraph(button, 2, [](const ForceGraph& g) { return removeRelease(g); }),
                     "has no state 3");
  requireEditRefusal(editGraph(button, 0, [](const ForceGraph& g) { return scaleTravel(g, 0.1); }),
                     "operating point");
}

TEST_CASE("a state is added as a copy and taken away again") {
  const Button momentary = require(tactileButton());
  const Button twoStates = require(addState(momentary, 0));
  REQUIRE(twoStates.states().size() == 2);
  CHECK(twoStates.states()[0].name == "unlocked");
  CHECK(twoStates.states()[1].name == "locked");
  CHECK(twoStates.states()[1].graph == momentary.states()[0].graph);
  requireEditRefusal(addState(twoStates, 0), "already has two states");
  const Button left = require(removeState(twoStates, 0));
  REQUIRE(left.states().size() == 1);
  CHECK(left.states()[0].name == "locked");
  requireEditRefusal(removeState(momentary, 0), "only this state");
  requireEditRefusal(removeState(twoStates, 2), "no state 3");
}
