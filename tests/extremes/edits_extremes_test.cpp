// SPDX-License-Identifier: GPL-3.0-or-later
// Every edit, by any number, on any curve: a curve that keeps the rules, or a failure that says what stood in
// the way.

#include <cmath>

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "tests/extremes/extreme_values.h"

using namespace detent;
using namespace detent::tests;

namespace {

void assertSound(const Result<StrokeCurve>& edited) {
  if (!edited) return assertNamed(edited.failure());
  const auto [low, high] = edited->forceRange_N();
  RC_ASSERT(std::isfinite(low) && std::isfinite(high));
  RC_ASSERT(edited->travel_mm() > 0);
}

template <class Value>
void assertNamedOrValue(const Result<Value>& edited) {
  if (!edited) assertNamed(edited.failure());
}

std::size_t anyIndex(std::size_t count) { return anyOf<std::size_t>(0, count - 1); }
std::size_t anyKnot(const StrokeCurve& curve) { return anyIndex(curve.knots().size()); }
double editPlaceOn(const StrokeCurve& curve) { return within(curve.start_mm(), curve.end_mm()); }
Stroke anyStroke() { return oneIn(2) ? Stroke::press : Stroke::release; }

/// Near the curve, or anything.
CurvePoint anyTarget(const StrokeCurve& curve) {
  if (oneIn(4)) return {anyDouble(), anyDouble()};
  const double x = editPlaceOn(curve);
  return {x, curve.force_N(x) * within(-2, 3)};
}

double editSpan(const StrokeCurve& curve) {
  const auto [low, high] = curve.forceRange_N();
  return std::max(std::abs(low), std::abs(high));
}

}  // namespace

TEST_CASE("edits of knots by any number") {
  holdsAlways("moveKnot", [] {
    const StrokeCurve curve = extremeCurve();
    assertSound(moveKnot(curve, anyKnot(curve), anyTarget(curve)));
  });
  holdsAlways("setSlopeBefore, setSlopeAfter, setSlope", [] {
    const StrokeCurve curve = extremeCurve();
    const double slope = oneIn(2) ? anyDouble() : within(-1, 1) * magnitude(1e-9, 1e9);
    assertSound(setSlopeBefore(curve, anyKnot(curve), slope));
    assertSound(setSlopeAfter(curve, anyKnot(curve), slope));
    assertSound(setSlope(curve, anyKnot(curve), slope));
  });
  holdsAlways("makeCorner, makeSmooth", [] {
    const StrokeCurve curve = extremeCurve();
    const std::size_t knot = anyKnot(curve);
    assertSound(makeCorner(curve, knot));
    const auto smooth = makeSmooth(curve, knot);
    assertSound(smooth);
    if (smooth)
      RC_ASSERT(smooth->knots()[knot].slopeBefore_N_per_mm == smooth->knots()[knot].slopeAfter_N_per_mm);
  });
  holdsAlways("insertKnot keeps the shape", [] {
    const StrokeCurve curve = extremeCurve();
    const auto more = insertKnot(curve, editPlaceOn(curve));
    assertSound(more);
    if (!more) return;
    const double x = editPlaceOn(curve);
    const double steep = std::abs(curve.slope_N_per_mm(x)) * curve.end_mm();
    RC_ASSERT(alike(more->force_N(x), curve.force_N(x), 1e-11, editSpan(curve) + steep));
  });
  holdsAlways("insertKnot, any place", [] {
    const StrokeCurve curve = extremeCurve();
    const double x = anyDouble();
    assertSound(insertKnot(curve, x));
  });
  holdsAlways("removeKnot", [] {
    const StrokeCurve curve = extremeCurve();
    const auto fewer = removeKnot(curve, anyKnot(curve));
    assertSound(fewer);
    if (fewer) RC_ASSERT(fewer->knots().size() + 1 == curve.knots().size());
  });
  holdsAlways("placeKnots", [] {
    const StrokeCurve curve = extremeCurve();
    std::vector<KnotPlace> targets;
    for (int i = count(0, 4); i > 0; --i) targets.push_back({anyKnot(curve), anyTarget(curve)});
    const auto moved = placeKnots(curve, targets);
    assertSound(moved);
    if (targets.empty()) RC_ASSERT(moved.ok() && *moved == curve);
  });
  holdsAlways("removeKnots", [] {
    const StrokeCurve curve = extremeCurve();
    std::vector<std::size_t> indices;
    for (int i = count(0, 6); i > 0; --i) indices.push_back(anyKnot(curve));
    assertSound(removeKnots(curve, indices));
  });
  holdsAlways("stretchOf, putStretch: taken out and put back it is the same curve", [] {
    const StrokeCurve curve = extremeCurve();
    double from = editPlaceOn(curve), to = editPlaceOn(curve);
    if (from > to) std::swap(from, to);
    const auto stretch = stretchOf(curve, from, to);
    if (!stretch) return assertNamed(stretch.failure());
    const auto again = putStretch(curve, *stretch);
    assertSound(again);
    if (!again) return;
    const double x = editPlaceOn(curve);
    const double steep = std::abs(curve.slope_N_per_mm(x)) * curve.end_mm();
    RC_ASSERT(alike(again->force_N(x), curve.force_N(x), 1e-10, editSpan(curve) + steep));
  });
  holdsAlways("stretchOf, putStretch, any numbers", [] {
    const StrokeCurve curve = extremeCurve();
    assertNamedOrValue(stretchOf(curve, anyDouble(), anyDouble()));
    std::vector<Knot> stretch;
    for (int i = count(0, 4); i > 0; --i)
      stretch.push_back({anyDouble(), anyDouble(), anyDouble(), anyDouble()});
    assertSound(putStretch(curve, stretch));
  });
}

TEST_CASE("edits of shapes by any number") {
  holdsAlways("moveTactilePoint: it stands where it was put", [] {
    const StrokeCurve curve = extremeCurve();
    const Stroke stroke = anyStroke();
    const auto points = tactilePoints(curve, stroke);
    RC_PRE(!points.empty());
    const std::size_t index = anyIndex(points.size());
    const CurvePoint to = oneIn(4) ? CurvePoint{anyDouble(), anyDouble()}
                                   : CurvePoint{points[index].displacement_mm * within(0.8, 1.2),
                                                points[index].force_N * within(0.8, 1.2)};
    const auto moved = moveTactilePoint(curve, stroke, index, to);
    assertSound(moved);
    if (moved)
      RC_ASSERT(alike(moved->force_N(to.displacement_mm), to.force_N, 1e-9, editSpan(curve)) ||
                alike(moved->forceBefore_N(to.displacement_mm), to.force_N, 1e-9, editSpan(curve)));
  });
  holdsAlways("moveTurn", [] {
    const StrokeCurve curve = extremeCurve();
    auto turns = curve.localMaxima();
    for (const CurvePoint& p : curve.localMinima()) turns.push_back(p);
    RC_PRE(!turns.empty());
    assertSound(moveTurn(curve, turns[anyIndex(turns.size())], anyTarget(curve)));
  });
  holdsAlways("setSnapRatio, any ratio", [] {
    const StrokeCurve curve = extremeCurve();
    const auto points = tactilePoints(curve, Stroke::press);
    RC_PRE(!points.empty());
    assertSound(setSnapRatio(curve, anyIndex(points.size()), oneIn(2) ? anyDouble() : within(0, 1)));
  });
  holdsAlways("moveSection, any way", [] {
    const StrokeCurve curve = extremeCurve();
    const Stroke stroke = anyStroke();
    const auto sections = sectionsOf(curve, stroke);
    const double by_mm = oneIn(4) ? anyDouble() : within(-0.1, 0.1) * curve.travel_mm();
    const double by_N = oneIn(4) ? anyDouble() : within(-0.1, 0.1) * editSpan(curve);
    assertSound(moveSection(curve, stroke, anyIndex(sections.size()), by_mm, by_N));
  });
  holdsAlways("addJump, any jump", [] {
    const StrokeCurve curve = extremeCurve();
    NewJump jump{editPlaceOn(curve), within(0, 0.5) * curve.travel_mm(), within(0, 1) * editSpan(curve)};
    if (oneIn(4)) jump = {anyDouble(), anyDouble(), anyDouble()};
    assertSound(addJump(curve, anyStroke(), jump));
  });
  holdsAlways("removeJump", [] {
    const StrokeCurve curve = extremeCurve();
    const Stroke stroke = anyStroke();
    const auto points = tactilePoints(curve, stroke);
    RC_PRE(!points.empty());
    assertSound(removeJump(curve, stroke, anyIndex(points.size())));
  });
  holdsAlways("makeLinear leaves no tactile point", [] {
    const StrokeCurve curve = extremeCurve();
    const auto linear = makeLinear(curve);
    assertSound(linear);
  });
  holdsAlways("scaleForce, any factor", [] {
    const StrokeCurve curve = extremeCurve();
    assertSound(scaleForce(curve, oneIn(2) ? anyDouble() : magnitude(1e-300, 1e300)));
  });
  holdsAlways("scaleTravel, any factor", [] {
    const StrokeCurve curve = extremeCurve();
    assertSound(scaleTravel(curve, oneIn(2) ? anyDouble() : magnitude(1e-300, 1e300)));
  });
  holdsAlways("scaled by a power of two and back: the same bits", [] {
    const StrokeCurve curve = extremeCurve();
    const double factor = std::ldexp(1.0, count(-10, 10));
    const auto there = scaleForce(*scaleTravel(curve, factor), factor);
    RC_ASSERT(there.ok());
    RC_ASSERT(*scaleTravel(*scaleForce(*there, 1 / factor), 1 / factor) == curve);
  });
}

TEST_CASE("edits of graphs and buttons by any number") {
  holdsAlways("mirrorPressToRelease: never above the press, and never below 0 where the press is not", [] {
    const ForceGraph graph = extremeGraph();
    const double hysteresis = oneIn(4) ? anyDouble() : magnitude(1e-12, 1e7);
    const auto mirrored = mirrorPressToRelease(graph, hysteresis);
    if (!mirrored) return assertNamed(mirrored.failure());
    const double slack = 1e-9 * (editSpan(graph.press()) + std::min(hysteresis, 1e7));
    for (const Knot& k : mirrored->release()->knots())
      RC_ASSERT(k.force_N <= std::max(graph.press().force_N(k.displacement_mm),
                                      graph.press().forceBefore_N(k.displacement_mm)) +
                                 slack);
  });
  holdsAlways("editStroke with any edit", [] {
    const ForceGraph graph = extremeGraph();
    const double factor = anyDouble();
    assertNamedOrValue(
        editStroke(graph, anyStroke(), [&](const StrokeCurve& c) { return scaleForce(c, factor); }));
  });
  holdsAlways("scaleForce, scaleTravel of graphs", [] {
    const ForceGraph graph = extremeGraph();
    const double factor = oneIn(2) ? anyDouble() : magnitude(1e-12, 1e12);
    assertNamedOrValue(scaleForce(graph, factor));
    assertNamedOrValue(scaleTravel(graph, factor));
  });
  holdsAlways("scaleForce, scaleTravel of buttons", [] {
    const Button button = extremeButton();
    const double factor = oneIn(2) ? anyDouble() : magnitude(1e-12, 1e12);
    assertNamedOrValue(scaleForce(button, factor));
    assertNamedOrValue(scaleTravel(button, factor));
  });
  holdsAlways("setOperatingPoint, setResetPoint, any place", [] {
    const Button button = extremeButton();
    const std::size_t state = anyIndex(button.states().size());
    assertNamedOrValue(setOperatingPoint(button, state, anyDouble()));
    assertNamedOrValue(setResetPoint(button, state, anyDouble()));
  });
  holdsAlways("setDamping, any points", [] {
    const Button button = extremeButton();
    std::vector<DampingPoint> damping;
    for (int i = count(0, 4); i > 0; --i) damping.push_back({anyDouble(), anyDouble()});
    assertNamedOrValue(setDamping(button, anyIndex(button.states().size()), damping));
  });
  holdsAlways("a state added and taken away leaves the button", [] {
    const Button button = extremeButton();
    RC_PRE(!button.selfLocking());
    const auto two = addState(button, 0);
    RC_ASSERT(two.ok() && two->selfLocking());
    const auto one = removeState(*two, 1);
    RC_ASSERT(one.ok());
    RC_ASSERT(one->states()[0].graph == button.states()[0].graph);
  });
}
