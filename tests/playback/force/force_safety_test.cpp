// SPDX-License-Identifier: GPL-3.0-or-later
// What must never hurt anybody: no reading, fault or order gets more out of the force loop than the limit
// times the ramp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/prepare/spring_button.h"
#include "tests/playback/force/force_run.h"
#include "tests/playback/sample_buttons.h"

namespace {

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

constexpr double largest_N = 5;

ForceDeviceProfile bench(double rate_Hz = 1000) {
  ForceDeviceProfile device = voiceCoilRig();
  device.limits.force_N = largest_N;
  device.rate_Hz = rate_Hz;
  return device;
}

constexpr double longestTravel_mm = 100;

/// A spring that reaches the limit of force at 20 mm and has the longest allowed travel, so that no position
/// here lies beyond it.
Button longSpring() {
  const Result<Button> button = springButton("long spring", {{0.25}, {}, longestTravel_mm});
  REQUIRE(button);
  return *button;
}

/// An engine on readings that a test makes up. Checks after every step the rules that must always hold.
class Watched {
 public:
  explicit Watched(double rate_Hz = 1000)
      : prepared_(forceOf(longSpring(), bench(rate_Hz))), engine_(prepared_.program) {}

  double step(const ForceReading& reading) {
    const double force_N = engine_.step(reading).force_N;
    const ForceLimits& limits = prepared_.program.limits;
    raised_s_ = engine_.silent() ? 0 : raised_s_ + prepared_.program.period_s;
    INFO("step " << engine_.last().index << " at " << reading.position_mm << " mm");
    CHECK(std::isfinite(force_N));
    CHECK(std::abs(force_N) <= limits.force_N);
    CHECK(std::abs(force_N) <= limits.force_N * raised_s_ / limits.startRamp_s + 1e-9);
    return force_N;
  }
  double at(double position_mm, bool fresh = true) { return step({position_mm, {}, fresh}); }
  /// Holds the handle at a position until the full force acts; returns that force.
  double restAt(double position_mm) {
    double force_N = 0;
    for (int i = 0; i * prepared_.program.period_s < 0.3; ++i) force_N = at(position_mm);
    return force_N;
  }
  /// Steps until there is no force at one position, in seconds.
  template <class Next>
  double secondsToSilence(Next next) {
    for (int i = 0; i < 1000; ++i) {
      if (next() == 0) return i * prepared_.program.period_s;
    }
    return 1000;
  }
  ForceEngine& engine() { return engine_; }
  double period_s() const { return prepared_.program.period_s; }

 private:
  PreparedForce prepared_;
  ForceEngine engine_;
  double raised_s_ = 0;
};

}  // namespace

TEST_CASE("force safety: from every depth it starts along the ramp of the largest force") {
  for (double depth_mm = -5; depth_mm <= 100; depth_mm += 0.5) {
    Watched w;
    double before_N = 0;
    for (int i = 0; i < 250; ++i) {
      const double force_N = w.at(depth_mm);
      CHECK(std::abs(force_N - before_N) <= largest_N * 0.001 / 0.2 + 1e-9);
      before_N = force_N;
    }
    if (depth_mm > 20) CHECK(before_N == largest_N);
  }
}

TEST_CASE("force safety: after a jump the force is gone in 15 ms and comes back only by a person's word") {
  for (const double from_mm : {2.0, 30.0}) {
    for (double jump_mm = 1; jump_mm <= 100; jump_mm = jump_mm < 10 ? jump_mm + 1 : jump_mm + 7) {
      for (const double to_mm : {from_mm + jump_mm, from_mm - jump_mm}) {
        Watched w;
        const double rested_N = w.restAt(from_mm);
        REQUIRE(rested_N != 0);
        INFO("from " << from_mm << " to " << to_mm);
        CHECK(w.secondsToSilence([&] { return w.at(to_mm); }) <= 0.015);
        for (int i = 0; i < 1000; ++i) CHECK(w.at(to_mm) == 0);
        CHECK(w.engine().halt() == ForceHalt::displaced);
        CHECK(w.engine().counts().displaced == 1);
        w.engine().rearm();
        CHECK(std::abs(w.at(to_mm)) < 0.1);
        if (to_mm > 0.5 && to_mm <= longestTravel_mm) CHECK(w.restAt(to_mm) != 0);
      }
    }
  }
}

TEST_CASE("force safety: one corrupt reading is bridged; the place that it named is not believed") {
  Watched w;
  const double rested_N = w.restAt(2);
  for (int i = 0; i < 20; ++i) {
    CHECK(w.at(7) == Approx(rested_N));
    for (int k = 0; k < 100; ++k) CHECK(w.at(2) == Approx(rested_N));
  }
  CHECK(w.engine().counts().displaced == 0);
}

TEST_CASE("force safety: an encoder that flickers moves no force and is found out") {
  for (const double flicker_mm : {0.6, 1.5, 4.0, 30.0}) {
    Watched w;
    const double rested_N = w.restAt(2);
    int i = 0;
    double largest = 0, silent_s = -1;
    for (; i < 100; ++i) {
      const double force_N = w.at(i % 2 == 0 ? 2 + flicker_mm : 2);
      largest = std::max(largest, std::abs(force_N) - std::abs(rested_N));
      if (force_N == 0 && silent_s < 0) silent_s = i * 0.001;
    }
    INFO(flicker_mm << " mm");
    CHECK(largest <= 1e-9);
    CHECK(silent_s >= 0);
    CHECK(silent_s <= 0.015);
    CHECK(w.engine().halt() == ForceHalt::displaced);
  }
}

TEST_CASE(
    "force safety: silence, late loops and what is no number take the force away in 15 ms at every rate") {
  for (const double rate_Hz : {250.0, 500.0, 1000.0, 4000.0}) {
    Watched silent(rate_Hz), wrong(rate_Hz);
    silent.restAt(2);
    wrong.restAt(2);
    CHECK(silent.secondsToSilence([&] { return silent.at(2, false); }) <= 0.015 - silent.period_s());
    CHECK(wrong.secondsToSilence([&] { return wrong.at(std::nan("")); }) <= 0.015 - wrong.period_s());
    CHECK(silent.restAt(2) != 0);  // the handle did not move, so the force comes back
    CHECK(wrong.restAt(2) != 0);
    ForceReading away;
    away.position_mm = 2;
    away.zero = ForceReading::Zero::lost;
    CHECK(silent.step(away) != 0);
    CHECK(silent.secondsToSilence([&] { return silent.at(2); }) <= 0.015);
    CHECK(silent.restAt(2) == 0);
    away.zero = ForceReading::Zero::found;
    silent.step(away);
    CHECK(silent.restAt(2) != 0);
  }
  Watched late;  // 30 ms nobody looked, and a hand went on: that is no jump
  for (int i = 0; i < 300; ++i) late.at(0.01 * i);
  ForceReading reading;
  reading.position_mm = 6;
  reading.periods = 30;
  late.step(reading);
  CHECK(late.engine().halt() == ForceHalt::none);
}

TEST_CASE("force safety: a missing reading is no standstill: the over-speed cut stays") {
  Watched w;
  w.restAt(2);
  double at_mm = 2;
  for (double speed = 0.2; speed < 2.6; speed += 0.4) w.at(at_mm += speed);
  for (int i = 0; i < 12; ++i) w.at(at_mm += 2.6);
  REQUIRE(w.engine().counts().tooFast == 1);
  for (int i = 0; i < 20; ++i) CHECK(w.at(at_mm += 2.6, i % 9 != 0) == 0);
  CHECK(w.engine().halt() == ForceHalt::none);
  CHECK(w.engine().counts().tooFast == 1);
}

TEST_CASE("force safety: an emergency stop is zero in 15 ms and stays zero until somebody arms") {
  for (const double rate_Hz : {250.0, 1000.0, 4000.0}) {
    Watched w(rate_Hz);
    REQUIRE(w.restAt(30) == largest_N);
    w.engine().emergencyStop();
    CHECK(w.secondsToSilence([&] { return w.at(30); }) <= 0.008);
    for (int i = 0; i < 2000; ++i) CHECK(w.at(30) == 0);
    ForceReading found;
    found.position_mm = 30;
    found.zero = ForceReading::Zero::found;
    CHECK(w.step(found) == 0);  // homing ends no emergency stop
    CHECK(w.restAt(30) == 0);
    w.engine().rearm();
    CHECK(w.restAt(30) == largest_N);
  }
}

TEST_CASE("force safety: hold-to-run gives force only while somebody holds") {
  Watched w;
  w.engine().setHeld(false);
  CHECK(w.restAt(30) == 0);
  w.engine().setHeld(true);
  CHECK(w.restAt(30) == largest_N);
  w.engine().setHeld(false);
  CHECK(w.secondsToSilence([&] { return w.at(30); }) <= 0.008);
}

TEST_CASE("force safety: no presses of any speed are taken for faults") {
  for (const double rate_Hz : {500.0, 1000.0, 4000.0}) {
    for (const double press_s : {0.012, 0.03, 0.1, 1.0}) {
      for (const ForceDeviceProfile& preset : {simulatedDevice(), falconDevice(), voiceCoilRig()}) {
        ForceDeviceProfile device = preset;
        device.rate_Hz = rate_Hz;
        const PreparedForce prepared = forceOf(tactileButton(), device);
        FingerPresses presses;
        presses.press_s = presses.release_s = press_s;
        presses.travel_mm = prepared.summary.travel_mm;
        ForceRun run(prepared, device, presses);
        run.run(3);
        INFO(device.name << ", " << rate_Hz << " Hz, " << press_s << " s");
        CHECK(run.engine().counts().absurd == 0);
        CHECK(run.engine().counts().displaced == 0);
      }
    }
  }
}

TEST_CASE("force safety: 10,000 random faults") {
  std::mt19937 random(20260101);  // NOLINT(cert-msc51-cpp)
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::uint64_t faults = 0;
  for (int press = 0; faults < 10000; ++press) {
    Watched w;
    double hand_mm = within(-1, 30), offset_mm = 0, pace_mm = 0;
    for (int i = 0; i < 1500; ++i) {
      pace_mm = std::clamp(pace_mm + within(-0.1, 0.1), -0.5, 0.5);
      hand_mm = std::clamp(hand_mm + pace_mm, -1.0, 40.0);
      ForceReading reading;
      reading.position_mm = hand_mm + offset_mm;
      const bool faulty = i > 250 && within(0, 1) < 0.02;
      if (faulty) {
        ++faults;
        switch (static_cast<int>(within(0, 8))) {
          case 0:
            reading.position_mm = std::nan("");
            break;
          case 1:
            reading.position_mm = std::numeric_limits<double>::infinity();
            break;
          case 2:
            reading.fresh = false;
            break;
          case 3:
            offset_mm += within(-100, 100);
            break;
          case 4:
            reading.position_mm += within(-5, 5);
            break;
          case 5:
            reading.periods = within(1, 60);
            break;
          case 6:
            reading.zero = ForceReading::Zero::lost;
            break;
          default:
            w.engine().emergencyStop();
            break;
        }
      }
      w.step(reading);
      if (w.engine().halt() != ForceHalt::none && within(0, 1) < 0.01) w.engine().rearm();
    }
  }
}
