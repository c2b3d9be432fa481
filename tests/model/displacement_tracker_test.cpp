// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/displacement_tracker.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "model/templates.h"
#include "tests/model/property.h"
#include "tests/model/random_curves.h"

using namespace detent;
using detent::tests::anyCurve;
using detent::tests::between;
using detent::tests::holdsAlways;

namespace {

// Straight pieces, so every inverse is known. Press: up to 0.6 at 1, down to 0.2 at 2, up to 1 at 4, wall
// to 2.
ForceGraph jumpGraph() {
  auto press = strokeFrom({{{0, 0}, {1, 0.6}, {2, 0.2}, {4, 1}, {4, 2}}, {0, 1, 2}});
  auto release = strokeFrom({{{0, 0}, {1, 0.4}, {1.5, 0.1}, {4, 0.9}, {4, 2}}, {0, 1, 2}});
  REQUIRE(press.ok());
  REQUIRE(release.ok());
  return *ForceGraph::fromCurves(*press, *release);
}

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("press rests at the tactile point and jumps when its force is exceeded") {
  DisplacementTracker tracker(jumpGraph());
  CHECK(tracker.update(0.3).displacement_mm == Approx(0.5));
  const TrackedPosition edge = tracker.update(0.6);
  CHECK(edge.displacement_mm == 1);
  CHECK_FALSE(edge.jumped);
  CHECK(tracker.update(0.6).displacement_mm == 1);
  const TrackedPosition over = tracker.update(std::nextafter(0.6, 1));
  CHECK(over.jumped);
  CHECK(over.displacement_mm == Approx(3));
  CHECK_FALSE(tracker.update(0.8).jumped);
  CHECK(tracker.position().displacement_mm == Approx(3.5));
}

TEST_CASE("a step across everything lands on the wall, and stays there while the wall carries") {
  DisplacementTracker tracker(jumpGraph());
  const TrackedPosition hit = tracker.update(1.7);
  CHECK(hit.displacement_mm == 4);
  CHECK(hit.jumped);
  CHECK(tracker.update(50).displacement_mm == 4);
  CHECK(tracker.update(1.0).displacement_mm == 4);
  CHECK(tracker.position().stroke == Stroke::release);
  CHECK(tracker.update(0.95).displacement_mm == 4);
  CHECK(tracker.update(0.5).displacement_mm < 4);
}

TEST_CASE("release rests at its tactile point and jumps below it") {
  DisplacementTracker tracker(jumpGraph());
  tracker.update(2);
  const TrackedPosition edge = tracker.update(0.1);
  CHECK(edge.displacement_mm == 1.5);
  CHECK_FALSE(edge.jumped);
  const TrackedPosition under = tracker.update(std::nextafter(0.1, 0));
  CHECK(under.jumped);
  CHECK(under.displacement_mm == Approx(0.25));
  CHECK(tracker.update(-1).displacement_mm == 0);
}

TEST_CASE("after a turn the finger waits between the two curves") {
  DisplacementTracker tracker(jumpGraph());
  tracker.update(0.8);
  CHECK(tracker.position().displacement_mm == Approx(3.5));
  CHECK(tracker.update(0.75).displacement_mm == Approx(3.5));  // release has 0.74 there
  CHECK(tracker.update(0.70).displacement_mm < 3.5);
  const double turned = tracker.position().displacement_mm;
  CHECK(tracker.update(0.75).displacement_mm == turned);
  CHECK(tracker.position().stroke == Stroke::press);
  CHECK(tracker.update(0.9).displacement_mm == Approx(3.75));
}

TEST_CASE("a partly released button is pressed again from inside the jump") {
  DisplacementTracker tracker(jumpGraph());
  tracker.update(1);
  tracker.update(0.3);  // release: 1.5 + 0.2 / 0.32 = 2.125 mm
  CHECK(tracker.position().displacement_mm == Approx(2.125));
  tracker.update(0.4);  // press from there: 2 + 0.2 / 0.4
  CHECK(tracker.position().displacement_mm == Approx(2.5));
  CHECK_FALSE(tracker.position().jumped);
}

TEST_CASE("hysteresis keeps sensor noise from turning the stroke") {
  TrackerSettings settings;
  settings.hysteresis_N = 0.05;
  DisplacementTracker tracker(jumpGraph(), settings);
  tracker.update(0.5);
  CHECK(tracker.update(0.46).stroke == Stroke::press);
  CHECK(tracker.update(0.45).stroke == Stroke::press);
  CHECK(tracker.update(0.44).stroke == Stroke::release);
  CHECK(tracker.update(0.48).stroke == Stroke::release);
  CHECK(tracker.update(0.50).stroke == Stroke::press);
}

TEST_CASE("a turn by exactly the hysteresis is none") {
  TrackerSettings settings;
  settings.hysteresis_N = 0.0625;
  DisplacementTracker tracker(jumpGraph(), settings);
  tracker.update(0.5);
  CHECK(tracker.update(0.4375).stroke == Stroke::press);
  CHECK(tracker.update(std::nextafter(0.4375, 0)).stroke == Stroke::release);
}

TEST_CASE("another graph is felt from the next press on, not before") {
  auto soft = strokeFrom({{{0, 0}, {4, 0.4}}, {0}});
  REQUIRE(soft.ok());
  const ForceGraph softGraph = *ForceGraph::fromCurves(*soft, {});
  DisplacementTracker changed(jumpGraph()), unchanged(jumpGraph());
  changed.update(0.8);
  unchanged.update(0.8);
  changed.continueOn(softGraph);
  for (double force : {0.85, 0.7, 0.3, 0.12}) CHECK(changed.update(force) == unchanged.update(force));
  const double before_mm = changed.position().displacement_mm;
  CHECK(before_mm < 2);
  CHECK(changed.update(0.3).displacement_mm == Approx(3));
}

TEST_CASE("a maximum that falls in a wall holds until it is exceeded") {
  auto press = StrokeCurve::fromKnots({{0, 0, 0, 1}, {1, 1, 1, 0}, {1, 0.2, 0, 1}, {3, 2.2, 1, 0}});
  REQUIRE(press.ok());
  DisplacementTracker tracker(*ForceGraph::fromCurves(*press, {}));
  CHECK(tracker.update(1).displacement_mm == 1);
  CHECK(tracker.update(1).displacement_mm == 1);
  CHECK(tracker.update(std::nextafter(1.0, 2)).displacement_mm == Approx(1.8));
}

TEST_CASE("flats are crossed when exceeded, without being jumps") {
  auto press = strokeFrom({{{0, 0}, {1, 0.5}, {2, 0.5}, {3, 1}}, {0, 1, 2}});
  REQUIRE(press.ok());
  DisplacementTracker tracker(*ForceGraph::fromCurves(*press, {}));
  CHECK(tracker.update(0.5).displacement_mm == 1);
  const TrackedPosition after = tracker.update(0.5001);
  CHECK(after.displacement_mm == Approx(2).margin(0.001));
  CHECK_FALSE(after.jumped);
}

TEST_CASE("numbers that are none are counted and change nothing") {
  DisplacementTracker tracker(jumpGraph());
  tracker.update(0.3);
  const TrackedPosition before = tracker.position();
  for (double bad : {notANumber, HUGE_VAL, -HUGE_VAL}) CHECK(tracker.update(bad) == before);
  CHECK(tracker.rejectedSamples() == 3);
  CHECK(tracker.update(0.36).displacement_mm == Approx(0.6));
  tracker.reset();
  CHECK(tracker.rejectedSamples() == 0);
  CHECK(tracker.position().displacement_mm == 0);
}

TEST_CASE("the first sample may be anything") {
  for (double first : {-5.0, 0.0, 1e300}) {
    DisplacementTracker tracker(jumpGraph());
    const double x = tracker.update(first).displacement_mm;
    CHECK(x >= 0);
    CHECK(x <= 4);
  }
}

TEST_CASE(
    "a tracker never leaves the graph, never goes back within a stroke, and sits where the curve says") {
  holdsAlways("DisplacementTracker", [] {
    const StrokeCurve press = anyCurve();
    auto graph = ForceGraph::fromCurves(press, anyCurve());
    if (!graph) graph = ForceGraph::fromCurves(press, {});
    RC_ASSERT(graph.ok());
    TrackerSettings settings;
    settings.hysteresis_N = between(0, 0.1);
    DisplacementTracker tracker(*graph, settings);
    const StrokeCurve& release = graph->curve(Stroke::release);
    TrackedPosition last = tracker.position();
    for (int i = 0; i < 200; ++i) {
      const double force = between(-0.5, 3);
      const TrackedPosition now = tracker.update(force);
      const double x = now.displacement_mm;
      RC_ASSERT(x >= std::min(press.start_mm(), release.start_mm()));
      RC_ASSERT(x <= std::max(press.end_mm(), release.end_mm()));
      if (now.stroke == Stroke::press) {
        RC_ASSERT(x >= last.displacement_mm);
        const double carried = std::max(press.forceBefore_N(x), press.force_N(x));
        RC_ASSERT(carried >= force - 1e-9 || x >= press.end_mm());
        // Nothing before it would have held: every place passed is weaker than the force.
        for (int k = 1; k < 20 && x > last.displacement_mm; ++k) {
          const double passed = last.displacement_mm + (x - last.displacement_mm) * k / 20;
          RC_ASSERT(press.force_N(passed) <= force + 1e-9);
        }
      } else {
        RC_ASSERT(x <= last.displacement_mm);
        const double carried = std::min(release.forceBefore_N(x), release.force_N(x));
        RC_ASSERT(carried <= force + 1e-9 || x <= release.start_mm());
      }
      last = now;
    }
  });
}

TEST_CASE("the same samples give the same positions however often the last is repeated") {
  holdsAlways("holding a force changes nothing", [] {
    DisplacementTracker tracker(*ForceGraph::fromCurves(anyCurve(), {}));
    for (int i = 0; i < 50; ++i) {
      const double force = between(-0.5, 3);
      const TrackedPosition first = tracker.update(force);
      const TrackedPosition again = tracker.update(force);
      RC_ASSERT(again.displacement_mm == first.displacement_mm);
      RC_ASSERT(!again.jumped);
    }
  });
}
