// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons on devices whose measured profile or link does not bear them: played so that nothing shakes, or
// refused with a remedy. Steady links without drop-outs.

#include "playback/fitted_force.h"

#include <cmath>
#include <optional>
#include <random>
#include <string>

#include <catch2/catch.hpp>
#include <pthread.h>
#include <sched.h>

#include "playback/device/round_trips.h"
#include "playback/open_force_device.h"
#include "playback/realtime/force_guard.h"
#include "tests/playback/force/force_run.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

ForceDeviceProfile measuredHandle(double mass_kg, double friction_N, double damping_Ns_per_mm,
                                  double step_mm) {
  ForceDeviceProfile device = simulatedDevice();
  device.mass_kg = mass_kg;
  device.friction_N = friction_N;
  device.damping_Ns_per_mm = damping_Ns_per_mm;
  device.step_mm = step_mm;
  device.measured = true;
  return device;
}

Result<FittedForce> kept(const Button& button, const ForceDeviceProfile& device) {
  Result<PreparedForce> prepared = prepareForce(button, device, {});
  if (!prepared) return prepared.failure();
  return keptTo(device, button, {}, *std::move(prepared));
}

/// Movement and force under a finger that rests in the middle of the travel, the last second of three.
Quiet resting(const FittedForce& fitted, const Button& button) {
  const double at_mm = fitted.prepared.summary.travel_mm / 2;
  const double carried_N = button.states().front().graph.press().force_N(at_mm) + fitted.device.friction_N;
  ForceRun run(fitted.prepared, fitted.device, FingerHold{at_mm, carried_N, 0.4});
  Quiet quiet;
  run.run(2);
  run.run(1, [&](const ForceStep& step) { quiet.add(step.position_mm, step.force_N); });
  return quiet;
}

}  // namespace

TEST_CASE(
    "fitted force: on the measured handle a button is steady, or it is refused with what would carry it") {
  const ForceDeviceProfile handles[] = {
      measuredHandle(0.05, 0, 5e-5, 0.038),    measuredHandle(0.05, 0, 5e-5, 0.01),
      measuredHandle(0.05, 0.002, 5e-5, 0.01), measuredHandle(0.02, 0.01, 5e-5, 0.01),
      measuredHandle(0.1, 0.05, 5e-4, 0.038),  measuredHandle(0.3, 0.02, 2e-3, 0.02),
      measuredHandle(0.05, 0.01, 5e-4, 0.001),
  };
  int played = 0, refused = 0;
  for (const ForceDeviceProfile& device : handles) {
    for (const Button& button : {linearButton(), tactileButton(), twoLevelButton(), lockingButton()}) {
      INFO(button.name() << " on " << device.mass_kg << " kg, " << device.friction_N << " N, "
                         << device.step_mm << " mm");
      const Result<FittedForce> fitted = kept(button, device);
      if (!fitted) {
        ++refused;
        CHECK(fitted.failure().code == FailureCode::deviceTrouble);
        CHECK(fitted.failure().sentence().find("would be stable") != std::string::npos);
        CHECK(fitted.failure().sentence().find(" 0 mm") == std::string::npos);
        continue;
      }
      ++played;
      const Quiet quiet = resting(*fitted, button);
      CHECK(quiet.peakToPeak_mm() <= 4.001 * device.step_mm);
      CHECK(quiet.rms_N() <= 0.050);
    }
  }
  CHECK(played >= 12);
  CHECK(refused >= 8);
}

TEST_CASE("fitted force: the friction that a refusal names carries the button") {
  ForceDeviceProfile device = measuredHandle(0.05, 0, 5e-5, 0.038);
  const Result<FittedForce> refused = kept(linearButton(), device);
  REQUIRE_FALSE(refused);
  const std::string said = refused.failure().sentence(), before = "friction of ";
  REQUIRE(said.find(before) != std::string::npos);
  device.friction_N = std::stod(said.substr(said.find(before) + before.size()));
  CHECK(device.friction_N > 0);
  CHECK(device.friction_N < 0.1);
  CHECK(kept(linearButton(), device));
}

TEST_CASE("fitted force: a preset is a guess and limits nothing; a measured handle has the controller on") {
  ForceDeviceProfile device = measuredHandle(0.05, 0, 5e-5, 0.038);
  device.measured = false;
  const Result<FittedForce> guessed = kept(twoLevelButton(), device);
  REQUIRE(guessed);
  CHECK_FALSE(guessed->prepared.program.passivityController);
  // Steeper than this handle bears at one place, not on the whole.
  const Result<FittedForce> limited = kept(twoLevelButton(), measuredHandle(0.05, 0.06, 5e-5, 0.02));
  REQUIRE(limited);
  CHECK(limited->prepared.program.passivityController);
  CHECK(limited->device.largestSlope_N_per_mm <= 6.001);
}

TEST_CASE("fitted force: a slow link is put down to this computer or to the device") {
  MarginPoint least;
  least.allowed_N_per_mm = 0.1;
  ForceLinkPace pace;
  pace.roundTrip_s = 0.008;
  pace.computer_s = 0.006;
  const std::string busy = tooSteepFor(simulatedDevice(), pace, least, 0.5).sentence();
  CHECK(busy.find("This computer is too slow: a message to itself takes 6 ms") != std::string::npos);
  CHECK(busy.find("device is too slow") == std::string::npos);
  pace.computer_s = 0.0002;
  const std::string slow = tooSteepFor(simulatedDevice(), pace, least, 0.5).sentence();
  CHECK(slow.find("The device is too slow") != std::string::npos);
  CHECK(slow.find("computer is too slow") == std::string::npos);
}

TEST_CASE("a link is measured with the priority that the loop will have") {
  const auto policy = [] {
    int now = 0;
    sched_param unused{};
    ::pthread_getschedparam(::pthread_self(), &now, &unused);
    return now;
  };
  const int before = policy();
  bool allowed = false;
  {
    const RealtimeWhile loop(forcePriority);
    allowed = policy() == SCHED_FIFO;
  }
  CHECK(policy() == before);
  if (!allowed) {
    WARN("SKIPPED: no real-time scheduling here");
    return;
  }
  {
    const RoundTrips trips;
    CHECK(policy() == SCHED_FIFO);
  }
  CHECK(policy() == before);
}

namespace {

/// A link and a computer that both take their time, in simulated time.
struct SteadyLink {
  double delay_s, jitter_s;
  double busy_s = 0;  ///< the computer passes answers on later by so much, for 8 ms of each second
};

struct OnSteadyLink {
  double rate_Hz = 0;
  std::uint64_t late = 0, fades = 0;
  double stopped_s = 0;  ///< from the last answer that came to no force
};

/// The loop as it is paced for a link, for a minute; then the answers stop.
OnSteadyLink pacedOn(const SteadyLink& link, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto answer_s = [&](double at_s) {
    const double share = static_cast<double>(engine() >> 11) * 0x1p-53;
    return link.delay_s + share * link.jitter_s + (std::fmod(at_s, 1) < 0.008 ? link.busy_s : 0);
  };
  RoundTrips trips;
  for (int i = 0; i < 40; ++i) trips.add(answer_s(0.1 + 0.002 * i));
  const double usual_s = trips.usual_s(), requested_s = 0.001;
  const double period_s = tooSlowFor(requested_s, usual_s) ? slowPeriod_s(requested_s, usual_s) : requested_s;
  const double wait_s = answerWaitOfPeriod * period_s;
  ForceLimits limits;
  ForceGuard guard(limits, period_s, 0.01);
  OnSteadyLink found;
  found.rate_Hz = 1 / period_s;
  double at_s = 0;
  for (; at_s < 60; at_s += period_s) {
    const bool fresh = answer_s(at_s) <= wait_s;
    guard.judge(1, fresh);
    guard.limit(1, fresh ? std::optional<double>(0) : std::nullopt);
  }
  found.late = guard.counts().missing;
  found.fades = guard.counts().faded;
  const double lastAnswer_s = at_s - period_s + link.delay_s;
  for (double force_N = 1; force_N > 0; at_s += period_s) {
    guard.judge(1, false);
    force_N = guard.limit(1, std::nullopt);
    found.stopped_s = at_s + wait_s - lastAnswer_s;
  }
  return found;
}

}  // namespace

TEST_CASE("steady links of 0.2 to 2 ms and 0.1 to 0.6 ms of jitter have no drop-out in a minute") {
  for (const double delay_ms : {0.2, 0.6, 1.0, 2.0}) {
    for (const double jitter_ms : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
      for (const double busy_ms : {0.0, 0.15}) {
        const OnSteadyLink found = pacedOn({1e-3 * delay_ms, 1e-3 * jitter_ms, 1e-3 * busy_ms}, 7);
        INFO(delay_ms << " ms + " << jitter_ms << " ms, busy " << busy_ms << " ms: " << found.rate_Hz
                      << " Hz, " << found.late << " late, stopped after " << found.stopped_s << " s");
        CHECK(found.fades == 0);
        if (busy_ms == 0) CHECK(found.late == 0);
        CHECK(found.stopped_s <= 0.020);
        CHECK(found.rate_Hz >= (delay_ms < 0.5 ? 700 : delay_ms < 1.5 ? 400 : 260));
      }
    }
  }
}
