// SPDX-License-Identifier: GPL-3.0-or-later
// The engine checks what it assumes of a device: that a force moves the handle the right way, that the
// encoder counts, that a motor takes energy out of a handle that moves against it. Simulated time throughout.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>

#include <catch2/catch.hpp>

#include "playback/prepare/device_test.h"
#include "playback/prepare/spring_button.h"
#include "playback/realtime/direction_proof.h"
#include "playback/realtime/test_forces.h"
#include "tests/playback/force/force_run.h"
#include "tests/playback/sample_buttons.h"

namespace {

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

/// A device wired by its user, of which the encoder can break and the motor's wires can be swapped.
ForceDeviceProfile wiredDevice() {
  ForceDeviceProfile device = voiceCoilRig();
  device.limits.force_N = 5;
  device.provesDirection = device.watchesEncoder = true;
  return device;
}

Button plainSpring(double stiffness_N_per_mm, double travel_mm) {
  const Result<Button> button = springButton("spring", {{stiffness_N_per_mm}, {}, travel_mm});
  REQUIRE(button);
  return *button;
}

/// An engine on a simulated handle whose motor and encoder can be turned round or stopped at any time.
class Wired {
 public:
  Wired(const Button& button, const ForceDeviceProfile& profile, const FingerPlan& plan,
        const SimulatedDeviceSettings* other = nullptr)
      : prepared_(forceOf(button, profile)),
        device_(other != nullptr ? *other : simulationOf(profile, prepared_),
                SimulatedFinger(FingerMechanics{}, plan)),
        engine_(prepared_.program) {}

  const ForceStep& step() {
    ForceCommand acting = command_;
    acting.force_N *= motor;
    ForceReading reading = device_.exchange(acting);
    const double before_mm = true_mm;
    true_mm = reading.position_mm;
    // Read up to so many periods before its time.
    reading.position_mm += share() * jitter * (before_mm - true_mm);
    reading.fresh = share() >= lost;
    if (!stopped_mm && counts == 0) stopped_mm = encoder * reading.position_mm;
    if (counts != 0) stopped_mm.reset();
    reading.position_mm = stopped_mm.value_or(turnedAt_mm + encoder * (reading.position_mm - turnedAt_mm));
    command_ = engine_.step(reading);
    time_s += prepared_.program.period_s;
    most_N = std::max(most_N, std::abs(command_.force_N));
    return engine_.last();
  }
  void runUntil(double end_s) {
    while (time_s < end_s - 1e-9) step();
  }
  /// Steps until there is no force, in seconds; 9 where it stays.
  double secondsToNothing() {
    for (const double from_s = time_s; time_s < from_s + 9;) {
      if (step().force_N == 0) return time_s - from_s;
    }
    return 9;
  }
  ForceEngine& engine() { return engine_; }
  const ForceProgram& program() const { return prepared_.program; }

  double motor = 1, encoder = 1, counts = 1;
  double turnedAt_mm = 0;       ///< position from which `encoder` counts the other way
  double jitter = 0, lost = 0;  ///< of the readings: in periods, as a share
  double true_mm = 0, most_N = 0, time_s = 0;
  std::optional<double> stopped_mm;

 private:
  double share() { return static_cast<double>(chance_() >> 11) * 0x1p-53; }

  PreparedForce prepared_;
  SimulatedForceDevice device_;
  ForceEngine engine_;
  ForceCommand command_;
  std::mt19937_64 chance_{46};
};

FingerPlan away() { return FingerForcePath{{0}, {0}}; }

}  // namespace

TEST_CASE("direction proof: it distinguishes reversed handles of every kind under 0.1 N") {
  for (const double mass_kg : {0.02, 0.05, 0.4}) {
    for (const double friction_N : {0.0, 0.02, 0.06}) {
      for (const double step_mm : {0.001, 0.01, 0.038}) {
        for (const double delay_s : {0.0, 0.004}) {
          for (const double start_mm : {0.0, 2.0}) {
            for (const double wired : {1.0, -1.0}) {
              ForceDeviceProfile profile = wiredDevice();
              profile.step_mm = step_mm;
              const PreparedForce prepared = forceOf(linearButton(), profile);
              SimulatedDeviceSettings handle = simulationOf(profile, prepared);
              handle.mass_kg = mass_kg;
              handle.friction_N = friction_N;
              handle.delay_s = delay_s;
              handle.start_mm = handle.lowest_mm = start_mm;  // at its stop
              SimulatedForceDevice device(handle, SimulatedFinger({}, away()));
              DirectionProof proof(prepared.program.proof, 0.001);
              ForceCommand command;
              double most_N = 0, farthest_mm = 0;
              for (int i = 0; i < 4000 && proof.verdict() == DirectionProof::Verdict::running; ++i) {
                const double read_mm = device.exchange(command).position_mm;
                farthest_mm = std::max(farthest_mm, std::abs(read_mm - start_mm));
                command.force_N = wired * proof.step_N(read_mm);
                most_N = std::max(most_N, std::abs(command.force_N));
              }
              INFO(mass_kg << " kg, " << friction_N << " N, " << step_mm << " mm, late by " << delay_s
                           << " s, wired " << wired);
              CHECK(proof.verdict() ==
                    (wired > 0 ? DirectionProof::Verdict::agrees : DirectionProof::Verdict::reversed));
              CHECK(most_N <= 0.1);
              CHECK(farthest_mm < 2.5);
            }
          }
        }
      }
    }
  }
}

TEST_CASE("direction proof: a hand that moves the handle by itself proves nothing") {
  for (const double wired : {1.0, -1.0}) {
    ForceDeviceProfile profile = wiredDevice();
    Wired w(linearButton(), profile, FingerPath{{0, 0.02, 0.6, 5}, {-1, -1, 12, 12}});
    w.motor = wired;
    w.runUntil(0.5);
    CHECK(w.most_N <= 0.1);
    CHECK(w.engine().last().proving);
  }
}

TEST_CASE(
    "a reversed motor or encoder gets no force above 0.1 N, a blocked handle or a dead encoder neither") {
  struct Case {
    const char* what;
    double motor, encoder, counts;
    ForceHalt halt;
  };
  for (const Case& c :
       {Case{"as it should be", 1, 1, 1, ForceHalt::none},
        Case{"motor reversed", -1, 1, 1, ForceHalt::reversed},
        Case{"encoder reversed", 1, -1, 1, ForceHalt::reversed},
        Case{"both reversed", -1, -1, 1, ForceHalt::none}, Case{"no motor", 0, 1, 1, ForceHalt::unmoved},
        Case{"dead encoder", 1, 1, 0, ForceHalt::unmoved}}) {
    Wired w(plainSpring(1, 10), wiredDevice(), away());
    w.motor = c.motor;
    w.encoder = c.encoder;
    w.counts = c.counts;
    w.runUntil(4);
    INFO(c.what);
    CHECK(w.engine().halt() == c.halt);
    CHECK(w.most_N <= 0.1);
    CHECK_FALSE(w.engine().last().proving);
    if (c.halt != ForceHalt::reversed) continue;
    // When the wiring is right again, the force starts only after a person rearms it.
    w.motor = w.encoder = w.counts = 1;
    w.engine().rearm();
    w.runUntil(5);
    CHECK(w.engine().halt() == ForceHalt::none);
  }
}

TEST_CASE("after the proof the force rises from nothing along the ramp; a small limit needs no proof") {
  Wired w(plainSpring(1, 10), wiredDevice(), FingerPath{{0, 0.4, 0.8}, {-1, -1, 8}});
  double proved_s = -1;
  while (w.time_s < 1.5) {
    const ForceStep& step = w.step();
    if (!step.proving && proved_s < 0) proved_s = w.time_s;
    if (proved_s >= 0) CHECK(std::abs(step.force_N) <= 5 * (w.time_s - proved_s + 0.001) / 0.2 + 1e-9);
  }
  CHECK(proved_s > 0);
  CHECK(proved_s < 0.2);
  CHECK(w.engine().last().force_N > 1.5);
  ForceDeviceProfile weak = wiredDevice();
  weak.limits.force_N = 0.05;
  CHECK_FALSE(forceOf(linearButton(), weak).program.proof.present);
}

TEST_CASE("a motor that turns round under a finger is off within 50 ms and 3 mm beyond the travel") {
  struct Press {
    Button button;
    double hold_mm, carried_N;
  };
  const Press presses[] = {{plainSpring(1, 10), 2.7, 2.75},
                           {plainSpring(0.2, 4), 2, 0.45},
                           {tactileButton(), 1, 0.5},
                           {plainSpring(1, 3), 2.7, 2.75}};
  for (const Press& press : presses) {
    for (const double mass_kg : {0.05, 0.1}) {
      const ForceDeviceProfile profile = wiredDevice();
      const PreparedForce prepared = forceOf(press.button, profile);
      SimulatedDeviceSettings handle = simulationOf(profile, prepared);
      handle.mass_kg = mass_kg;  // the preset does not know
      Wired w(press.button, profile, FingerHold{press.hold_mm, press.carried_N, 0.2}, &handle);
      w.runUntil(1.2);
      INFO(press.button.name() << " held at " << w.true_mm << " mm with " << w.engine().last().force_N
                               << " N, " << mass_kg << " kg");
      REQUIRE(w.engine().halt() == ForceHalt::none);
      REQUIRE(w.engine().last().force_N > 0.1);
      w.motor = -1;
      const double off_s = w.secondsToNothing();
      CHECK(off_s <= 0.05);
      CHECK(w.engine().halt() == ForceHalt::runaway);
      CHECK(w.true_mm <= w.program().limits.travelEnd_mm + 3);
      w.runUntil(w.time_s + 1);
      CHECK(w.engine().last().force_N == 0);
    }
  }
}

namespace {

/// Checks that an encoder that turns round as the finger leaves is off within 50 ms and 3 mm outside the
/// travel.
void turnsRound(double mass_kg, double jitter, double lost) {
  const ForceDeviceProfile profile = wiredDevice();
  const Button button = plainSpring(1, 10);
  const PreparedForce prepared = forceOf(button, profile);
  SimulatedDeviceSettings handle = simulationOf(profile, prepared);
  handle.mass_kg = mass_kg;
  handle.lowest_mm = -40;
  Wired w(button, profile, FingerForcePath{{0, 0.3, 0.5, 1.2, 1.202}, {0, 0, 2.7, 2.7, 0}}, &handle);
  w.runUntil(1.2);
  INFO(mass_kg << " kg, readings early by " << jitter << " periods, lost " << lost);
  REQUIRE(w.engine().last().force_N > 2);
  w.encoder = -1;
  w.turnedAt_mm = w.true_mm;
  w.jitter = jitter;
  w.lost = lost;
  CHECK(w.secondsToNothing() <= 0.05);
  CHECK(w.engine().halt() == ForceHalt::runaway);
  CHECK(w.true_mm >= -3);
}

}  // namespace

TEST_CASE("an encoder that turns round as the finger leaves: off within 50 ms and 3 mm outside the travel") {
  for (const double mass_kg : {0.05, 0.1})
    for (const double jitter : {0.0, 0.25, 0.5})
      for (const double lost : {0.0, 0.05, 0.1}) turnsRound(mass_kg, jitter, lost);
  for (const double lost : {0.0, 0.05, 0.1}) turnsRound(0.1, 1, lost);
}

// 13.9 mm outside: the readings pass for a lost place, which takes the force away less quickly.
TEST_CASE("a turned encoder of 50 g, read up to a whole period early", "[!shouldfail]") {
  turnsRound(0.05, 1, 0);
}

TEST_CASE("an encoder that turns round below the force limit: off within 3 mm outside the travel") {
  for (const double stiffness_N_per_mm : {0.3, 0.5, 0.8, 1.0}) {
    for (const double held_mm : {1.0, 1.5, 2.0, 2.5}) {
      ForceDeviceProfile profile = wiredDevice();
      profile.limits.force_N = 3;
      const Button button = plainSpring(stiffness_N_per_mm, 4);
      const PreparedForce prepared = forceOf(button, profile);
      SimulatedDeviceSettings handle = simulationOf(profile, prepared);
      handle.mass_kg = 0.1;  // the preset does not know
      handle.lowest_mm = -40;
      const double push_N = held_mm * stiffness_N_per_mm;
      Wired w(button, profile, FingerForcePath{{0, 0.3, 0.5, 1.2, 1.202}, {0, 0, push_N, push_N, 0}},
              &handle);
      w.runUntil(1.2);
      w.encoder = -1;
      w.turnedAt_mm = w.true_mm;
      CHECK(w.secondsToNothing() <= 0.1);
      INFO(stiffness_N_per_mm << " N/mm held at " << held_mm << " mm");
      CHECK(w.engine().halt() == ForceHalt::runaway);
      CHECK(w.true_mm >= -3);
    }
  }
}

TEST_CASE("a handle that lost readings threw beyond its travel gets no force there") {
  for (const double stiffness_N_per_mm : {0.8, 1.5}) {
    ForceDeviceProfile profile = wiredDevice();
    profile.limits.force_N = 3;
    const Button button = plainSpring(stiffness_N_per_mm, 4);
    const PreparedForce prepared = forceOf(button, profile);
    SimulatedDeviceSettings handle = simulationOf(profile, prepared);
    handle.mass_kg = 0.1;
    Wired w(button, profile, FingerForcePath{{0, 0.3, 0.5}, {0, 0, 1.2}}, &handle);
    w.runUntil(1.2);
    REQUIRE(w.engine().halt() == ForceHalt::none);
    w.lost = 0.6;
    double farthest_mm = 0, outside_mm = 0;
    while (w.time_s < 2.2) {
      const double force_N = w.step().force_N;
      farthest_mm = std::max(farthest_mm, w.true_mm - 4);
      if (force_N > 0.1) outside_mm = std::max(outside_mm, w.true_mm - 4);
    }
    INFO(stiffness_N_per_mm << " N/mm");
    CHECK(farthest_mm > 3);
    CHECK(outside_mm < 3);
  }
}

TEST_CASE("a handle that drop-outs of the force threw beyond its travel: it is the drop-outs that are said") {
  Wired w(plainSpring(1, 10), wiredDevice(), FingerForcePath{{0, 0.3, 0.5}, {0, 0, 4}});
  w.runUntil(1.2);
  REQUIRE(w.engine().halt() == ForceHalt::none);
  w.lost = 0.34;
  w.runUntil(2.2);
  CHECK(w.engine().halt() == ForceHalt::dropOuts);
  CHECK(w.engine().last().force_N == 0);
}

TEST_CASE("presses of any speed and strength within the limit are no runaways") {
  for (const ForceDeviceProfile& preset : {simulatedDevice(), voiceCoilRig(), wiredDevice()}) {
    for (const double press_s : {0.03, 0.06, 0.12, 0.5}) {
      for (const double force_N : {0.5, 1.0, 2.0}) {
        for (const Button& button : {tactileButton(), plainSpring(0.3, 4)}) {
          ForceDeviceProfile device = preset;
          device.limits.force_N = 5;
          const PreparedForce prepared = forceOf(button, device);
          ForceRun run(prepared, device,
                       FingerPresses{prepared.summary.travel_mm, force_N, press_s, press_s, 0.3});
          run.run(3);
          INFO(device.name << ", " << button.name() << ", " << press_s << " s, " << force_N << " N");
          CHECK(run.engine().halt() == ForceHalt::none);
        }
      }
    }
  }
}

TEST_CASE(
    "pressed harder than the limit, the handle loses its force 2 mm beyond the travel, and it is said") {
  ForceDeviceProfile device = wiredDevice();
  device.limits.force_N = 1;
  device.provesDirection = false;
  Wired w(tactileButton(), device, FingerForcePath{{0, 0.3, 0.8}, {0, 0, 2.5}});
  w.runUntil(2);
  CHECK(w.engine().halt() == ForceHalt::runaway);
  CHECK(w.engine().last().force_N == 0);
}

TEST_CASE("a dead encoder under a resting finger takes the force away within 350 ms, and for good") {
  for (const double at_mm : {0.8, 1.6, 2.7}) {
    Wired w(plainSpring(1, 10), wiredDevice(), FingerHold{at_mm, at_mm + 0.05, 0.2});
    w.runUntil(1.2);
    INFO("held at " << w.true_mm << " mm");
    REQUIRE(w.engine().halt() == ForceHalt::none);
    REQUIRE(w.engine().last().force_N > 0.25);
    w.counts = 0;
    CHECK(w.secondsToNothing() <= 0.35);
    w.runUntil(w.time_s + 1);
    CHECK(w.engine().halt() == ForceHalt::deadCount);
    CHECK(w.engine().last().force_N == 0);
    w.counts = 1;
    w.runUntil(w.time_s + 1);
    CHECK(w.engine().last().force_N == 0);
    w.engine().rearm();
    w.runUntil(w.time_s + 1);
    CHECK(w.engine().halt() == ForceHalt::none);
  }
}

TEST_CASE("a handle that friction holds still is only probed: its encoder answers and the force comes back") {
  const ForceDeviceProfile device = wiredDevice();
  {
    for (const double at_mm : {0.8, 1.6, 2.7}) {
      Wired w(plainSpring(1, 10), device, FingerHold{at_mm, at_mm + device.friction_N, 0.2});
      w.runUntil(1.5);
      double least_N = 1e9, most_N = 0, low_mm = 1e9, high_mm = -1e9;
      while (w.time_s < 6) {
        const ForceStep& step = w.step();
        least_N = std::min(least_N, step.force_N);
        most_N = std::max(most_N, step.force_N);
        low_mm = std::min(low_mm, w.true_mm);
        high_mm = std::max(high_mm, w.true_mm);
      }
      INFO(device.name << " at " << at_mm << " mm: " << w.engine().counts().probed << " probes, " << least_N
                       << " to " << most_N << " N, " << low_mm << " to " << high_mm << " mm");
      CHECK(w.engine().halt() == ForceHalt::none);
      CHECK(w.engine().counts().probed > 0);
      CHECK(most_N - least_N < 0.4);
      CHECK(high_mm - low_mm < 0.3);
    }
  }
}

TEST_CASE("identify-device's first pushes: what moves is moved, a dead encoder or a blocked handle said") {
  struct Case {
    double motor, counts;
    bool blocked;
  };
  for (const Case& c : {Case{1, 1, false}, Case{-1, 1, false}, Case{1, 0, false}, Case{1, 1, true}}) {
    for (const double mass_kg : {0.02, 0.1, 1.0}) {
      for (const double friction_N : {0.0, 0.05, 0.4}) {
        for (const double step_mm : {0.001, 0.04}) {
          ForceDeviceProfile profile = wiredDevice();
          profile.step_mm = step_mm;
          profile.limits.force_N = 1;
          const PreparedForce prepared = forceOf(linearButton(), profile);
          SimulatedDeviceSettings handle = simulationOf(profile, prepared);
          handle.mass_kg = mass_kg;
          handle.friction_N = friction_N;
          handle.lowest_mm = c.blocked ? 0 : -60;
          handle.highest_mm = c.blocked ? 0 : 60;
          SimulatedForceDevice device(handle, SimulatedFinger({}, away()));
          ForceProgram program = prepared.program;
          program.excitation = relayTest(program, 10);
          TestForces test(program);
          ForceCommand command;
          double farthest_mm = 0, read_mm = 0, followed_mm = 0;
          for (int i = 0; i < 2000 && !test.reversed() && !test.unmoved(); ++i) {
            const double true_mm = device.exchange(command).position_mm;
            farthest_mm = std::max(farthest_mm, std::abs(true_mm));
            read_mm = c.counts * true_mm;
            followed_mm = std::max(followed_mm, read_mm);
            command.force_N = c.motor * test.step_N(read_mm, 0);
            if (followed_mm > 2) break;
          }
          INFO(mass_kg << " kg, " << friction_N << " N, " << step_mm << " mm, motor " << c.motor
                       << ", counts " << c.counts << ", blocked " << c.blocked);
          CHECK(test.reversed() == (c.motor < 0));
          CHECK(test.unmoved() == (c.counts == 0 || c.blocked));
          CHECK((followed_mm > 2) == (c.motor > 0 && c.counts == 1 && !c.blocked));
          CHECK(farthest_mm < (c.counts == 0 ? 40 : c.motor < 0 ? 1 : 5));
        }
      }
    }
  }
}
