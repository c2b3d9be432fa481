// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/force_guard.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "playback/realtime/force_engine.h"

namespace {

using namespace detent::playback;

constexpr double period_s = 0.001, step_mm = 0.01;

/// A guard that has let the whole force through.
ForceGuard running(const ForceLimits& limits = {}) {
  ForceGuard guard(limits, period_s, step_mm);
  for (int i = 0; i < 300; ++i) {
    guard.judge(1, true);
    guard.limit(1, 0);
  }
  return guard;
}

}  // namespace

TEST_CASE("force guard: the start ramps in") {
  ForceGuard guard({}, period_s, step_mm);
  double before_N = 0;
  for (int i = 0; i < 220; ++i) {
    guard.judge(0, true);
    const double force_N = guard.limit(2, 0);
    CHECK(force_N - before_N <= 2 * period_s / 0.2 + 1e-12);
    before_N = force_N;
  }
  CHECK(before_N == 2);
}

TEST_CASE("force guard: bad readings are held for three samples, then the force is gone within 10 ms") {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                        1e6, 40};
  for (const double reading : bad) {
    ForceGuard guard = running();
    for (int i = 0; i < 3; ++i) {
      CHECK(guard.judge(reading, true) != ReadingVerdict::good);
      CHECK(guard.limit(1, 0) == 1);
    }
    for (int i = 0; i < 10; ++i) {
      guard.judge(std::nan(""), true);
      CHECK(guard.limit(1, 0) < 1);
    }
    CHECK(guard.silent());
    CHECK(guard.counts().faded == 1);
  }
  ForceGuard late = running();
  for (int i = 0; i < 13; ++i) {
    CHECK(late.judge(1, false) == ReadingVerdict::missing);
    late.limit(1, 0);
  }
  CHECK(late.silent());
  CHECK(late.counts().missing == 13);
  // Good readings slowly bring the force back.
  for (int i = 0; i < 5; ++i) late.judge(1, true);
  CHECK(late.limit(1, 0) < 0.02);
}

TEST_CASE("force guard: force, its change and speed are limited and counted") {
  ForceLimits limits;
  limits.force_N = 5;
  limits.slew_N_per_s = 2000;
  ForceGuard guard = running(limits);
  guard.judge(1, true);
  CHECK(guard.limit(1000, 0) == Approx(1 + limits.slew_N_per_s * period_s));
  for (int i = 0; i < 10; ++i) CHECK(guard.limit(1000, 0) <= 5);
  CHECK(guard.limit(std::numeric_limits<double>::quiet_NaN(), 0) == 0);
  CHECK(guard.counts().forceLimited > 5);
  CHECK(guard.counts().slewLimited > 0);
  for (int i = 0; i < 10; ++i) {
    guard.judge(1, true);
    guard.limit(1, 5000);
  }
  CHECK(guard.silent());
  CHECK(guard.counts().tooFast == 1);
}

TEST_CASE("force guard: after a stop the force is gone within 10 ms and stays gone") {
  ForceGuard guard = running();
  guard.stop();
  for (int i = 0; i < 10; ++i) {
    guard.judge(1, true);
    guard.limit(1, 0);
  }
  CHECK(guard.silent());
  for (int i = 0; i < 300; ++i) {
    guard.judge(1, true);
    CHECK(guard.limit(1, 0) == 0);
  }
}

TEST_CASE("force guard: a count that stops dead out of a movement takes the force, and gives it back") {
  struct Case {
    double mm_per_s, force_N, watchedAbove_N;
    bool gone;
  };
  constexpr double never = std::numeric_limits<double>::infinity();
  for (const Case& c : {Case{400, 2, never, true}, Case{60, 2, never, true}, Case{20, 2, never, false},
                        Case{60, 0.5, never, false},  // too little to surprise anybody
                        Case{60, 0.5, 0.25, true}, Case{60, 0.2, 0.25, false}}) {
    ForceLimits limits;
    limits.deadCountAbove_N = c.watchedAbove_N;
    ForceGuard guard(limits, period_s, step_mm);
    double at_mm = 0, force_N = 0;
    for (int i = 0; i < 300; ++i) {
      guard.judge(std::round((at_mm += c.mm_per_s * period_s) / step_mm) * step_mm, true);
      force_N = guard.limit(c.force_N, c.mm_per_s);
    }
    INFO(c.mm_per_s << " mm/s, " << c.force_N << " N, watched above " << c.watchedAbove_N << " N");
    CHECK(force_N == Approx(c.force_N));
    const auto stay = [&](int readings) {
      for (int i = 0; i < readings; ++i) {
        guard.judge(std::round(at_mm / step_mm) * step_mm, true);
        force_N = guard.limit(c.force_N, 0);
      }
    };
    stay(6);
    CHECK(force_N == Approx(c.force_N));
    stay(7);
    CHECK(force_N == Approx(c.gone ? 0 : c.force_N).margin(1e-9));
    CHECK((guard.counts().frozen > 0) == c.gone);
    CHECK(guard.halt() == ForceHalt::none);
    at_mm += 2 * step_mm;  // leaves the hard stop
    stay(1);
    for (int i = 0; i < 20; ++i) {
      at_mm += 2 * step_mm;
      stay(1);
    }
    CHECK(force_N == Approx(c.force_N));
    // An encoder that never counts again is given up, if it is watched.
    stay(450);
    CHECK((guard.halt() == ForceHalt::deadCount) == (c.force_N > c.watchedAbove_N));
  }
  ForceGuard returned({}, period_s, step_mm);  // to its stop, where it rests under the button's first force
  double kept_N = 0;
  for (int i = 0; i < 600; ++i) {
    returned.judge(std::max(0.0, 30 - 0.1 * i), true);
    kept_N = returned.limit(2, i < 300 ? -100 : 0);
  }
  CHECK(kept_N == Approx(2));
  ForceGuard finger({}, period_s, step_mm);  // turns on a bottom-out, 0.5 mm deep
  for (int i = 0; i < 600; ++i) {
    const double at_mm = std::round(0.5 * std::sin(0.18 * 0.05 * i * 20) / step_mm) * step_mm;
    finger.judge(at_mm, true);
    finger.limit(2, 0);
  }
  CHECK(finger.counts().frozen == 0);
}

TEST_CASE("force guard: a handle that moves by itself is stopped by nobody, but loses the force") {
  ForceLimits limits;
  ForceGuard guard(limits, period_s, step_mm);
  double at_mm = 0, force_N = 0;
  for (int i = 0; i < 300; ++i) guard.judge(0, true), force_N = guard.limit(3, 0);
  CHECK(force_N == 3);
  for (int i = 0; i < 30; ++i) {
    guard.judge(at_mm += 2.5, true);
    force_N = guard.limit(3, 2500);
  }
  CHECK(force_N == 0);
  CHECK(guard.counts().tooFast == 1);
}

TEST_CASE("force guard: more than three drop-outs within a second are a halt until a person arms") {
  ForceGuard guard = running();
  const auto dropOut = [&] {
    for (int i = 0; i < 14; ++i) guard.judge(1, false), guard.limit(1, 0);
    for (int i = 0; i < 6; ++i) guard.judge(1, true), guard.limit(1, 0);
  };
  for (int i = 0; i < 3; ++i) dropOut();
  CHECK(guard.halt() == ForceHalt::none);
  dropOut();
  CHECK(guard.halt() == ForceHalt::dropOuts);
  for (int i = 0; i < 500; ++i) {
    guard.judge(1, true);
    CHECK(guard.limit(1, 0) == 0);
  }
  guard.rearm();
  for (int i = 0; i < 300; ++i) guard.judge(1, true), guard.limit(1, 0);
  CHECK(guard.gain() == 1);
  // As many silences with time between them do not stop the force.
  ForceGuard calm = running();
  for (int k = 0; k < 8; ++k) {
    for (int i = 0; i < 14; ++i) calm.judge(1, false), calm.limit(1, 0);
    for (int i = 0; i < 400; ++i) calm.judge(1, true), calm.limit(1, 0);
  }
  CHECK(calm.halt() == ForceHalt::none);
}

TEST_CASE("force guard: after a pause longer than a device waits, the force begins at nothing") {
  for (const double pause_periods : {13.0, 58.0}) {
    ForceGuard guard = running();
    CHECK(guard.limit(1, 0) == 1);
    guard.judge(1, true, pause_periods);
    double before_N = guard.limit(1, 0);
    CHECK(before_N == 0);
    for (int i = 0; i < 250; ++i) {
      guard.judge(1, true);
      const double force_N = guard.limit(1, 0);
      CHECK(force_N - before_N <= period_s / 0.2 + 1e-12);
      before_N = force_N;
    }
    CHECK(before_N == 1);
    CHECK(guard.counts().stalled == 1);
  }
  ForceGuard brief = running();
  brief.judge(1, true, 8);
  CHECK(brief.limit(1, 0) == 1);
}

TEST_CASE("force guard: a handle that runs on after a pause has lost its place, and is no runaway") {
  ForceLimits ends;
  ends.travelEnd_mm = 4;
  for (const bool paused : {true, false}) {
    ForceGuard guard = running(ends);
    double at_mm = paused ? 5.5 : 1;
    guard.judge(at_mm, true, paused ? 20 : 1);
    for (int i = 0; i < 80 && guard.halt() == ForceHalt::none; ++i) {
      guard.limit(5, 100);
      guard.judge(at_mm += 0.1, true);
    }
    CHECK(guard.halt() == (paused ? ForceHalt::displaced : ForceHalt::runaway));
  }
}

TEST_CASE("force guard: a handle that an interruption of the force threw beyond its travel is a halt") {
  for (const bool paused : {true, false}) {
    for (const double beyond_mm : {1.5, 2.5}) {  // of a travel of 4 mm
      ForceLimits ends;
      ends.travelEnd_mm = 4;
      ForceGuard guard = running(ends);
      REQUIRE(guard.gain() == 1);
      const int missing = paused ? 1 : 20;
      for (int i = 0; i < missing; ++i) guard.judge(1, false, paused ? 58 : 1), guard.limit(1, 0);
      REQUIRE(guard.gain() == 0);
      for (int i = 0; i < 250; ++i) guard.judge(4 + beyond_mm, true), guard.limit(1, 0);
      const ForceHalt thrown = paused ? ForceHalt::displaced : ForceHalt::dropOuts;
      INFO((paused ? "paused, " : "without readings, ") << beyond_mm << " mm beyond the travel");
      CHECK(guard.halt() == (beyond_mm < 2 ? ForceHalt::none : thrown));
      CHECK(guard.gain() == (beyond_mm < 2 ? 1 : 0));
      guard.rearm();
      for (int i = 0; i < 250; ++i) guard.judge(4, true), guard.limit(1, 0);
      CHECK(guard.gain() == 1);
    }
  }
}
