// SPDX-License-Identifier: GPL-3.0-or-later
// Measures a force device without a finger: moves it by test_forces.h and evaluates it by identify_motion.h.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "playback/device/force_loop.h"
#include "playback/force_feedback.h"
#include "playback/open_force_device.h"
#include "playback/prepare/device_test.h"
#include "playback/prepare/spring_button.h"

namespace detent::playback {

namespace {

constexpr double shortestRange_mm = 4, longestRange_mm = 80;
// After this time the start-up ramps of device and loop are over, so the force is the commanded one.
constexpr double rampsOver_s = 0.25;
constexpr double moved_mm = 0.25;
// After a pause of this length no device still gives the commanded force (docs/reference/force-protocol.md).
constexpr double longPause_s = 0.01;
constexpr auto checkEvery = std::chrono::milliseconds(20);

Failure trouble(const ForceDeviceChoice& device, const std::string& problem, const std::string& remedy) {
  return {FailureCode::deviceTrouble, device.port.empty() ? device.profile.name : device.port, "", problem,
          remedy};
}

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// A measurement in progress.
class Measuring {
 public:
  Measuring(const DeviceMeasurementSettings& settings, const std::function<bool(double)>& onward)
      : settings_(settings), device_(settings.run.device), onward_(onward) {}

  Result<DeviceMeasurement> run() {
    if (Result<Done> opened = open(); !opened) return opened.failure();
    if (Result<Done> relay = record(stepsOf(relayTest_s), false); !relay) return relay.failure();
    if (Result<Done> moved = checkMoved(); !moved) return moved.failure();
    Result<MotionIdentification> roughly = identifyMotion(record_);
    if (!roughly) return reported(roughly.failure());
    program_->excitation =
        chirpTest(*program_, settings_.range_mm, roughly->mass_kg.value, roughly->friction_N.value);
    loop_->setProgram(*program_);
    if (Result<Done> chirp = record(stepsOf(chirpTest_s), true); !chirp) return chirp.failure();
    orders_.reset();
    loop_.reset();
    Result<MotionIdentification> motion = identifyMotion(record_);
    if (!motion) return reported(motion.failure());
    return measured(*motion);
  }

 private:
  Result<Done> open() {
    if (!(settings_.range_mm >= shortestRange_mm && settings_.range_mm <= longestRange_mm)) {
      return Failure{FailureCode::wrongUsage, "--range", "",
                     "the value is " + numberText(settings_.range_mm) + " mm", "Give 4 to 80"};
    }
    ForceLimits& limits = device_.profile.limits;
    if (!(settings_.largest_N > 0 && settings_.largest_N <= limits.force_N)) {
      return Failure{FailureCode::wrongUsage, "--max-N", "",
                     "the value is " + numberText(settings_.largest_N) + " N",
                     "Give one above 0, up to " + numberText(limits.force_N)};
    }
    limits.force_N = settings_.largest_N;
    limits.lowest_mm = std::max(limits.lowest_mm, -settings_.range_mm);
    limits.highest_mm = std::min(limits.highest_mm, 2 * settings_.range_mm);
    device_.uploadTable = false;
    // The button provides rate, limits and steps; its law is not played.
    Result<Button> none = springButton("no button", {{1e-3}, {}, std::min(4.0, settings_.range_mm)});
    if (!none) return none.failure();
    ForceSettings force;
    force.rate_Hz = settings_.run.force.rate_Hz;
    Result<PreparedForce> prepared = prepareForce(*none, device_.profile, force);
    if (!prepared) return prepared.failure();
    program_ = std::make_unique<ForceProgram>(prepared->program);
    // The relay's own growing push proves the direction, at any position of the handle, so no separate proof
    // is needed.
    program_->proof.present = false;
    program_->limits.deadCountFrom_mm = -std::numeric_limits<double>::infinity();
    program_->limits.travelEnd_mm = std::numeric_limits<double>::infinity();
    Result<std::unique_ptr<ForceDevice>> opened =
        openForceDevice(device_, *prepared, FingerForcePath{{0}, {0}});
    if (!opened) return opened.failure();
    return keepPaceOf(**opened)
               ? started(*std::move(opened))
               : Result<Done>(trouble(device_, "the device does not accept the limits for a slow connection",
                                      "Check that the firmware follows docs/reference/force-protocol.md"));
  }

  bool keepPaceOf(ForceDevice& opened) {
    const std::optional<double> roundTrip_s = opened.measureRoundTrip_s();
    if (!roundTrip_s || !tooSlowFor(program_->period_s, *roundTrip_s)) return true;
    roundTrip_s_ = *roundTrip_s;
    program_->period_s = slowPeriod_s(program_->period_s, roundTrip_s_);
    return opened.setPace(program_->period_s);
  }

  Result<Done> started(std::unique_ptr<ForceDevice> opened) {
    record_.step_mm = program_->step_mm;
    program_->excitation = relayTest(*program_, settings_.range_mm);
    loop_ = std::make_unique<ForceLoop>(std::move(opened), *program_,
                                        ForceLoopSettings{.paced = settings_.run.paced,
                                                          .holdToRun = settings_.run.holdToRun,
                                                          .waitsAfter_steps = stepsOf(relayTest_s)});
    Result<std::unique_ptr<ForceOrders>> orders = startForceOrders(*loop_, settings_.run);
    if (!orders) return orders.failure();
    orders_ = *std::move(orders);
    return Done{};
  }

  std::int64_t stepsOf(double seconds) const { return std::llround(seconds / program_->period_s); }

  /// Records this many more steps, and those that arrived meanwhile, except at the end.
  Result<Done> record(std::int64_t steps, bool end) {
    for (const std::int64_t until = seen_ + steps;;) {
      const ForceLoopStatus status = loop_->status();
      take(end ? until : std::numeric_limits<std::int64_t>::max());
      if (seen_ >= until) return Done{};
      if (Result<Done> fine = check(status); !fine) return fine;
      if (status.finished) return trouble(device_, "was stopped before it was measured", "Measure it again");
      if (!onward_(std::min(1.0, time_s_ / (relayTest_s + chirpTest_s))))
        return Failure::cancelled(device_.profile.name);
      std::this_thread::sleep_for(checkEvery);
    }
  }

  Result<Done> check(const ForceLoopStatus& status) const {
    if (status.device == ForceDeviceState::lost)
      return trouble(device_, "is lost", "Check the cable, let the handle rest, and measure again");
    if (status.halt == ForceHalt::stopped)
      return trouble(device_, "was stopped", "Let the handle rest and measure again");
    if (status.halt == ForceHalt::reversed)
      return trouble(device_, "the polarity is reversed: the handle moves against the commanded force",
                     "Swap the motor's two wires or the encoder's A and B (of an ODrive: calibrate motor and "
                     "encoder anew)");
    if (status.halt == ForceHalt::deadCount) {
      return trouble(device_,
                     "the encoder did not count one step under force: it is dead, or the handle is stuck",
                     "Turn the handle by hand and see whether the position changes; check the encoder and "
                     "its wires, then free "
                     "the handle");
    }
    if (status.halt == ForceHalt::dropOuts)
      return trouble(device_, "the readings failed again and again",
                     "Check the cable, close what else runs on this computer, and measure again");
    if (status.halt == ForceHalt::runaway)
      return trouble(device_, "the handle ran on against the whole force",
                     "Clear its way, let it rest, and measure again");
    if (status.halt == ForceHalt::displaced) {
      return longestPause_s_ < longPause_s
                 ? trouble(device_, "moved out of its range, or its position jumped",
                           "Clear its way, or give a larger --range")
                 : trouble(device_,
                           "moved out of its range: this computer paused for " +
                               numberText(1e3 * longestPause_s_) + " ms meanwhile",
                           "Close what else runs, let the handle rest, and measure again");
    }
    return Done{};
  }

  void take(std::int64_t most) {
    steps_.clear();
    loop_->takeSteps(steps_);
    for (const ForceStep& step : steps_) {
      if (seen_ >= most) return;
      ++seen_;
      const double since_s = between_s(before_, step, program_->period_s);
      before_ = step;
      time_s_ += since_s;
      longestPause_s_ = std::max(longestPause_s_, since_s - program_->period_s);
      if (!from_mm_ && step.good) from_mm_ = step.position_mm;
      if (time_s_ < rampsOver_s) continue;
      if (!record_.time_s.empty() && time_s_ <= record_.time_s.back()) continue;
      record_.time_s.push_back(time_s_);
      record_.position_mm.push_back(step.position_mm);
      record_.force_N.push_back(step.force_N);
      record_.good.push_back(step.good);
    }
  }

  // The relay's first push is towards the middle.
  Result<Done> checkMoved() const {
    const double toMiddle = settings_.range_mm / 2 - from_mm_.value_or(0);
    double most_mm = 0;
    for (std::size_t k = 0; k < record_.position_mm.size(); ++k) {
      const double way_mm = std::copysign(1.0, toMiddle) * (record_.position_mm[k] - from_mm_.value_or(0));
      most_mm = std::max(most_mm, way_mm);
    }
    if (most_mm > moved_mm) return Done{};
    return trouble(device_, "the position does not follow " + numberText(settings_.largest_N) + " N",
                   "Turn the handle by hand: a position that stays the same means a dead encoder. Else free "
                   "the handle and take "
                   "the finger off");
  }

  Failure reported(const Failure& failure) const {
    Failure named = failure;
    named.subject = device_.port.empty() ? device_.profile.name : device_.port;
    return named;
  }

  DeviceMeasurement measured(const MotionIdentification& motion) {
    const auto value = [](const Estimate& e) { return ForceDeviceMeasurement::Value{e.value, e.sigma}; };
    DeviceMeasurement done;
    done.device.name = device_.profile.name;
    done.device.mass_kg = value(motion.mass_kg);
    done.device.friction_N = value(motion.friction_N);
    done.device.damping_Ns_per_mm = value(motion.damping_Ns_per_mm);
    done.device.delay_s = value(motion.delay_s);
    done.device.lag_s = value(motion.lag_s);
    done.device.late_s = value(motion.late_s);
    done.device.rate_Hz = 1 / program_->period_s;
    done.device.step_mm = program_->step_mm;
    done.motion = motion;
    done.record = std::move(record_);
    done.roundTrip_s = roundTrip_s_;
    done.longestPause_s = longestPause_s_;
    return done;
  }

  const DeviceMeasurementSettings& settings_;
  ForceDeviceChoice device_;
  const std::function<bool(double)>& onward_;
  std::unique_ptr<ForceProgram> program_;
  std::unique_ptr<ForceLoop> loop_;
  std::unique_ptr<ForceOrders> orders_;  ///< uses the loop, so it is declared after it
  std::vector<ForceStep> steps_;
  ForceStep before_;
  MotionRecord record_;
  std::optional<double> from_mm_;
  std::int64_t seen_ = 0;  ///< number of steps, including those that are not recorded
  double time_s_ = 0, roundTrip_s_ = 0, longestPause_s_ = 0;
};

}  // namespace

Result<DeviceMeasurement> measureForceDevice(const DeviceMeasurementSettings& settings,
                                             const std::function<bool(double done)>& onward) {
  return Measuring(settings, onward).run();
}

}  // namespace detent::playback
