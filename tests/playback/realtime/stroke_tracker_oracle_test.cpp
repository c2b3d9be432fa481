// SPDX-License-Identifier: GPL-3.0-or-later
// StrokeTracker against reverse_function.h on the same polylines: whatever the curve and the way, both stand
// at the same place.

#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/realtime/stroke_tracker.h"
#include "tests/model/property.h"
#include "tests/model/random_curves.h"
#include "tests/playback/realtime/reverse_function.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;
using detent::tests::anyCurve;
using detent::tests::between;
using detent::tests::holdsAlways;

namespace {

/// The curve that the tracker follows: a table's vertices, joined by straight lines.
StrokeCurve polyline(const StrokeTable& table) {
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < table.pointCount; ++i)
    knots.push_back({table.points[i].displacement_mm, table.points[i].force_N, 0, 0});
  for (std::size_t i = 1; i < knots.size(); ++i) {
    Knot &a = knots[i - 1], &b = knots[i];
    if (a.displacement_mm == b.displacement_mm) continue;
    a.slopeAfter_N_per_mm = b.slopeBefore_N_per_mm =
        (b.force_N - a.force_N) / (b.displacement_mm - a.displacement_mm);
  }
  Result<StrokeCurve> curve = StrokeCurve::fromKnots(std::move(knots));
  RC_ASSERT(curve.ok());
  return *std::move(curve);
}

/// A program of any press curve, its release some force below it, as a table of a random button.
HapticProgram anyProgram() {
  const StrokeCurve press = anyCurve();
  std::vector<Knot> weaker = press.knots();
  const double loss = between(0, 0.6);
  for (Knot& knot : weaker) knot.force_N -= loss;
  Result<StrokeCurve> release = StrokeCurve::fromKnots(std::move(weaker));
  RC_ASSERT(release.ok());
  Result<ForceGraph> graph = ForceGraph::fromCurves(press, *std::move(release));
  RC_ASSERT(graph.ok());
  HapticProgram program = programOf(buttonOf("any", {ButtonState{"", *std::move(graph), {}, {}, {}}}));
  program.hysteresis_N = between(0.001, 0.3);
  return program;
}

}  // namespace

TEST_CASE("tracker: on any curve it stands where the reverse function says (property)") {
  holdsAlways("StrokeTracker stands where ReverseFunction does", [] {
    const auto program = std::make_unique<HapticProgram>(anyProgram());
    const StateProgram& state = program->states[0];
    Result<ForceGraph> graph = ForceGraph::fromCurves(polyline(state.press), polyline(state.release));
    RC_ASSERT(graph.ok());
    ReverseFunction oracle(*graph, program->hysteresis_N);
    StrokeTracker tracker;
    tracker.use(program.get());
    double force_N = 0;
    for (int step = 0; step < 200; ++step) {
      // Above rest: stroke_tracker_test.cpp tests the reset by a lifted finger.
      force_N = step % 3 == 0 ? between(0.01, 2.5) : std::max(0.01, force_N + between(-0.2, 0.2));
      tracker.updateForce(force_N);
      oracle.update(force_N);
      RC_ASSERT(tracker.position().releasing == oracle.releasing());
      RC_ASSERT(std::abs(tracker.position().displacement_mm - oracle.displacement_mm()) < 1e-9);
    }
  });
}
