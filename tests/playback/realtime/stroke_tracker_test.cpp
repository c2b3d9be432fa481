// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/stroke_tracker.h"

#include <cmath>
#include <map>
#include <memory>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

struct Totals {
  std::uint64_t grains = 0, pressJumps = 0, releaseJumps = 0, bottomOuts = 0, closed = 0, opened = 0;
  std::vector<CrossingKind> order;  // without grains

  void add(const Crossings& crossings) {
    double last = 0;
    for (std::size_t i = 0; i < crossings.count; ++i) {
      const Crossing& c = crossings.items[i];
      CHECK(c.fraction >= last);
      CHECK(c.fraction <= 1);
      last = c.fraction;
      switch (c.kind) {
        case CrossingKind::grain:
          grains += c.count;
          continue;
        case CrossingKind::pressJump:
          ++pressJumps;
          break;
        case CrossingKind::releaseJump:
          ++releaseJumps;
          break;
        case CrossingKind::bottomOut:
          ++bottomOuts;
          break;
        case CrossingKind::contactClosed:
          ++closed;
          break;
        case CrossingKind::contactOpened:
          ++opened;
          break;
      }
      order.push_back(c.kind);
    }
  }
};

std::uint64_t trackerGrainPositions(const StrokeTable& table) {
  std::uint64_t n = 0;
  for (std::size_t i = 0; i < table.slopeCount; ++i) {
    if (table.slopes[i].last >= table.slopes[i].first) {
      n += static_cast<std::uint64_t>(table.slopes[i].last - table.slopes[i].first + 1);
    }
  }
  return n;
}

/// Raised cosine from 0 to `peak_N` and back.
double pressForce(double t, double duration, double peak_N) {
  return t <= 0 || t >= duration ? 0 : peak_N * 0.5 * (1 - std::cos(2 * M_PI * t / duration));
}

}  // namespace

TEST_CASE("tracker: a press of any speed crosses every grain, jump and bottom-out once, in order") {
  for (const Button& button : {linearButton(), tactileButton(), twoLevelButton()}) {
    const auto program = std::make_unique<HapticProgram>(programOf(button));
    for (double duration : {0.004, 0.01, 0.06, 0.5, 5.0}) {
      StrokeTracker tracker;
      tracker.use(program.get());
      Totals t;
      for (double time = 0; time <= duration + 0.01; time += 1.0 / 425) {
        t.add(tracker.updateForce(pressForce(time, duration, 30)));
      }
      const StateProgram& s = program->states[0];
      INFO(button.name() << " in " << duration << " s");
      if (duration < 0.004 + 1e-9) {
        CHECK(t.grains == trackerGrainPositions(s.press) + trackerGrainPositions(s.release));
      }
      CHECK(t.grains == trackerGrainPositions(s.press) + trackerGrainPositions(s.release));
      CHECK(t.pressJumps == s.press.jumpCount);
      CHECK(t.releaseJumps == s.release.jumpCount);
      CHECK(t.bottomOuts == 1);
      CHECK(tracker.position().displacement_mm == s.start_mm);
    }
  }
}

TEST_CASE("tracker: grain positions are what the paper says, 20 per mm outside jumps") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  CHECK(trackerGrainPositions(program->states[0].press) == 80);
  CHECK(trackerGrainPositions(program->states[0].release) == 80);
  const auto tactile = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const JumpEntry& jump = tactile->states[0].press.jumps[0];
  CHECK(jump.from_mm == Approx(1.2));
  const auto cells = [](double x) { return static_cast<long>(std::floor(x * 20 + 1e-9)); };
  CHECK(trackerGrainPositions(tactile->states[0].press) ==
        static_cast<std::uint64_t>(80 - (cells(jump.to_mm) - cells(jump.from_mm))));
}

TEST_CASE("tracker: no grain lost or doubled whatever the way (property)") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  CHECK(rc::check("net grains equal net cells on a linear button", [&] {
    StrokeTracker tracker;
    tracker.use(program.get());
    std::int64_t up = 0, down = 0;
    const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000));
    for (int step : steps) {
      const bool before = tracker.position().releasing;
      const double x0 = tracker.position().displacement_mm;
      const Crossings& c = tracker.updateForce(step * 0.001);
      const double x1 = tracker.position().displacement_mm;
      std::int64_t n = 0;
      for (std::size_t i = 0; i < c.count; ++i) {
        if (c.items[i].kind == CrossingKind::grain) n += c.items[i].count;
      }
      RC_ASSERT(n ==
                std::llabs(static_cast<long long>(std::floor(x1 * 20 + 1e-9) - std::floor(x0 * 20 + 1e-9))));
      (x1 >= x0 ? up : down) += n;
      if (x1 < x0) RC_ASSERT(tracker.position().releasing);
      if (x1 > x0) RC_ASSERT(!tracker.position().releasing);
      (void)before;
    }
    for (double f : {0.0}) {
      const Crossings& c = tracker.updateForce(f);
      for (std::size_t i = 0; i < c.count; ++i) {
        if (c.items[i].kind == CrossingKind::grain) down += c.items[i].count;
      }
    }
    RC_ASSERT(up == down);
  }));
}

TEST_CASE("tracker: a crossing's time is when the force reached the curve there") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  StrokeTracker tracker;
  tracker.use(program.get());
  tracker.updateForce(0.1);
  const Crossings& c = tracker.updateForce(0.7);
  REQUIRE(c.count >= 80);
  for (std::size_t i = 0; i + 1 < c.count; ++i) {  // the last is at the bottom together with the bottom-out
    if (c.items[i].kind != CrossingKind::grain) continue;
    CHECK(c.items[i].fraction == Approx((c.items[i].displacement_mm * 0.15) / 0.6).margin(1e-4));
  }
}

TEST_CASE("tracker: chatter at a tactile point fires once until the re-arm position") {
  PlaybackSettings settings;
  settings.hysteresis_N = 0.001;
  // Press and release on one curve: the worst case, no mechanical hysteresis.
  const Button button =
      buttonOf("no hysteresis", {stateOf("", {{0, 0}, {1, 0.6}, {1.3, 0.55}, {1.6, 0.6}, {3, 1.0}}, {})});
  const auto program = std::make_unique<HapticProgram>(programOf(button, settings));
  REQUIRE(program->states[0].press.jumpCount == 1);
  StrokeTracker tracker;
  tracker.use(program.get());
  Totals t;
  for (int i = 0; i < 1000; ++i) t.add(tracker.updateForce(i % 2 == 0 ? 0.605 : 0.595));
  CHECK(t.pressJumps == 1);
  // Back beyond the re-arm distance and up again: it is felt again.
  t.add(tracker.updateForce(0.4));
  t.add(tracker.updateForce(0.605));
  CHECK(t.pressJumps == 2);
}

TEST_CASE("tracker: noise below the hysteresis moves nothing backwards and repeats no grain") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  StrokeTracker tracker;
  tracker.use(program.get());
  Totals t;
  for (int i = 0; i < 100; ++i) t.add(tracker.updateForce(0.4));
  const auto before = t.grains;
  for (int i = 0; i < 1000; ++i) t.add(tracker.updateForce(0.4 - (i % 7) * 0.0025));
  CHECK(t.grains == before);
}

TEST_CASE("tracker: a self-locking button alternates its states at each actuation") {
  const auto program = std::make_unique<HapticProgram>(programOf(lockingButton()));
  REQUIRE(program->stateCount == 2);
  StrokeTracker tracker;
  tracker.use(program.get());
  for (int press = 0; press < 6; ++press) {
    CHECK(tracker.position().state == press % 2);
    Totals t;
    for (int i = 0; i <= 100; ++i) t.add(tracker.updateForce(2.0 * i / 100));
    for (int i = 100; i >= 0; --i) t.add(tracker.updateForce(2.0 * i / 100));
    CHECK(t.closed == 1);
    CHECK(t.opened == 1);
    CHECK(t.pressJumps == (press % 2 == 0 ? 1 : 0));
    CHECK(t.releaseJumps == (press % 2 == 0 ? 0 : 1));
  }
  // Half a press does not actuate.
  for (double f : {0.3, 0.5, 0.3, 0.0}) tracker.updateForce(f);
  CHECK(tracker.position().state == 0);
}

TEST_CASE("tracker: a latching button rests where it latches and comes up with the next press") {
  // Unlocked: pressed from 0, latches at 2.5 mm. Locked: pressed from 2.5 mm, released to 0.
  const Button button =
      buttonOf("latch", {stateOf("unlocked", {{0, 0.1}, {2, 0.6}, {4, 1.2}}, {{2.5, 0.1}, {4, 1.1}}),
                         stateOf("locked", {{2.5, 0.1}, {4, 1.2}}, {{0, 0.05}, {2, 0.4}, {4, 1.1}})});
  const auto program = std::make_unique<HapticProgram>(programOf(button));
  StrokeTracker tracker;
  tracker.use(program.get());
  const auto press = [&](double peak) {
    Totals t;
    for (int i = 0; i <= 200; ++i) t.add(tracker.updateForce(peak * i / 200));
    for (int i = 200; i >= 0; --i) t.add(tracker.updateForce(peak * i / 200));
    return t.grains;
  };
  CHECK(press(1.5) == 80 + 30);
  CHECK(tracker.position().displacement_mm == 2.5);
  CHECK(tracker.position().state == 1);
  CHECK(press(0.4) > 0);  // not far enough: stays latched
  CHECK(tracker.position().displacement_mm == 2.5);
  CHECK(tracker.position().state == 1);
  CHECK(press(1.5) == 30 + 80);
  CHECK(tracker.position().displacement_mm == 0);
  CHECK(tracker.position().state == 0);
}

TEST_CASE("tracker: displacement readings cross the same places") {
  for (const Button& button : {linearButton(), tactileButton(), twoLevelButton()}) {
    const auto program = std::make_unique<HapticProgram>(programOf(button));
    const StateProgram& s = program->states[0];
    for (int steps : {1, 3, 17, 400}) {
      StrokeTracker tracker;
      tracker.use(program.get());
      Totals t;
      for (int i = 0; i <= steps; ++i) t.add(tracker.updateDisplacement(s.end_mm * i / steps));
      for (int i = steps; i >= 0; --i) t.add(tracker.updateDisplacement(s.end_mm * i / steps));
      INFO(button.name() << " in " << steps);
      CHECK(t.grains == trackerGrainPositions(s.press) + trackerGrainPositions(s.release));
      CHECK(t.pressJumps == s.press.jumpCount);
      CHECK(t.releaseJumps == s.release.jumpCount);
      CHECK(t.bottomOuts == 1);
    }
  }
}

TEST_CASE("tracker: flat force, vertical rises and far too long travels stay in bounds") {
  const Button flat = buttonOf("flat", {stateOf("", {{0, 0.5}, {3, 0.5}}, {{0, 0.4}, {3, 0.4}})});
  const auto program = std::make_unique<HapticProgram>(programOf(flat));
  StrokeTracker tracker;
  tracker.use(program.get());
  Totals t;
  t.add(tracker.updateForce(0.3));
  CHECK(tracker.position().displacement_mm == 0);
  const Crossings& c = tracker.updateForce(0.6);
  CHECK(tracker.position().displacement_mm == 3);
  // All met at one force, spread over the rest of the interval instead of sounding as one.
  double last = 0;
  for (std::size_t i = 0; i < c.count; ++i) {
    if (i > 0 && c.items[i].kind == CrossingKind::grain) CHECK(c.items[i].fraction > last);
    last = c.items[i].fraction;
  }
  const Button lift = buttonOf("lift", {stateOf("", {{0, 0}, {50000, 1}, {100000, 2}}, {})});
  const auto tall = std::make_unique<HapticProgram>(programOf(lift));
  tracker.use(tall.get());
  Totals far;
  far.add(tracker.updateForce(3));
  far.add(tracker.updateForce(0));
  CHECK(far.grains == 2 * trackerGrainPositions(tall->states[0].press));
}

TEST_CASE("tracker: more grains in one reading than there is room for are counted by those before them") {
  // Cranked all the way down, so that the table keeps a piece for each knot: more pieces than crossings have
  // room.
  std::vector<CurvePoint> points;
  for (int i = 0; i <= 1400; ++i) points.push_back({100.0 * i / 1400, 0.002 * i + (i % 2 == 0 ? 0 : 0.001)});
  const Button cranked = buttonOf("cranked", {stateOf("", points, {})});
  const auto program = std::make_unique<HapticProgram>(programOf(cranked));
  REQUIRE(program->states[0].press.pointCount > Crossings::capacity - maxJumps);
  StrokeTracker tracker;
  tracker.use(program.get());
  const Crossings& crossed = tracker.updateForce(10);
  CHECK(crossed.count <= Crossings::capacity);
  Totals t;
  t.add(crossed);
  CHECK(t.grains == trackerGrainPositions(program->states[0].press));
  CHECK(t.bottomOuts == 1);
}

namespace {

struct OpenState {
  const char* name;
  std::vector<CurvePoint> press, release;
  std::uint64_t pressGrains, releaseGrains;
};

/// States whose strokes end at different places, as E and F of the paper played alone, and one that closes.
const std::vector<OpenState>& openStates() {
  static const std::vector<OpenState> states{
      {"E alone", {{0, 0.3}, {4, 0.9}}, {{2.5, 0.05}, {4, 0.85}}, 80, 30},
      {"F alone", {{2.5, 0.2}, {4, 0.9}}, {{0, 0.1}, {4, 0.85}}, 30, 80},
      {"release from 3 mm", {{0, 0.3}, {4, 0.9}}, {{0, 0.1}, {3, 0.6}}, 80, 60},
      {"closed", {{0, 0.3}, {4, 0.9}}, {{0, 0.2}, {4, 0.85}}, 80, 80},
  };
  return states;
}

}  // namespace

TEST_CASE("tracker: a state whose strokes end at different places plays each stroke's own grains") {
  for (const OpenState& open : openStates()) {
    for (const bool operates : {false, true}) {
      ButtonState state = stateOf("", open.press, open.release);
      if (operates) state.operatingPoint_mm = 3.6;
      const auto program = std::make_unique<HapticProgram>(programOf(buttonOf(open.name, {state})));
      for (const bool byForce : {true, false}) {
        StrokeTracker tracker;
        tracker.use(program.get());
        for (int press = 0; press < 3; ++press) {
          Totals down, up;
          std::uint64_t mostAtOnce = 0;
          for (int i = 0; i <= 2000; ++i) {
            const double share = i <= 1000 ? i / 1000.0 : (2000 - i) / 1000.0;
            Totals now;
            now.add(byForce ? tracker.updateForce(share) : tracker.updateDisplacement(4 * share));
            mostAtOnce = std::max(mostAtOnce, now.grains);
            (i <= 1000 ? down : up).grains += now.grains;
          }
          INFO(open.name << ", press " << press << (byForce ? " by force" : " by displacement"));
          CHECK(down.grains == open.pressGrains);
          CHECK(up.grains == open.releaseGrains);
          CHECK(mostAtOnce <= 2);
        }
      }
    }
  }
}

TEST_CASE("tracker: a press that has not actuated goes back to its start without the way beyond it") {
  // F alone: a finger that only rests on it must not play the release from 2.5 mm to 0.
  ButtonState state = stateOf("", {{2.5, 0.2}, {4, 0.9}}, {{0, 0.1}, {4, 0.85}});
  for (const bool operates : {false, true}) {
    if (operates) state.operatingPoint_mm = 3.6;
    const auto program = std::make_unique<HapticProgram>(programOf(buttonOf("F alone", {state})));
    StrokeTracker tracker;
    tracker.use(program.get());
    Totals touch;
    for (const double force_N : {0.05, 0.15, 0.19, 0.1, 0.0, 0.18, 0.0})
      touch.add(tracker.updateForce(force_N));
    CHECK(touch.grains == 0);
  }
}

TEST_CASE("tracker: half a press of a self-locking state is not let go in one click") {
  const auto program = std::make_unique<HapticProgram>(programOf(
      buttonOf("latch", {stateOf("unlocked", {{0, 0.1}, {2, 0.6}, {4, 1.2}}, {{2.5, 0.1}, {4, 1.1}}),
                         stateOf("locked", {{2.5, 0.1}, {4, 1.2}}, {{0, 0.05}, {2, 0.4}, {4, 1.1}})})));
  StrokeTracker tracker;
  tracker.use(program.get());
  std::uint64_t mostAtOnce = 0, grains = 0;
  for (int i = 0; i <= 1000; ++i) {
    Totals now;
    now.add(tracker.updateForce(0.5 * (i <= 500 ? i : 1000 - i) / 500));
    mostAtOnce = std::max(mostAtOnce, now.grains);
    grains += now.grains;
  }
  CHECK(grains == 32);  // 1.6 mm of the press; its release has no curve there
  CHECK(mostAtOnce <= 2);
  CHECK(tracker.position().state == 0);
  CHECK(tracker.position().displacement_mm == 0);
}
