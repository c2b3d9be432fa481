// SPDX-License-Identifier: GPL-3.0-or-later
// ForcePlayer: runs prepare/, realtime/ and device/ for the public header.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "playback/device/force_loop.h"
#include "playback/device/force_orders.h"
#include "playback/device/odrive_force_device.h"
#include "playback/device/own_delay.h"
#include "playback/device/serial_force_device.h"
#include "playback/fitted_force.h"
#include "playback/force_feedback.h"
#include "playback/open_force_device.h"

namespace detent::playback {

namespace {

double strongestForce_N(const Button& button, double limit_N) {
  double strongest_N = 0;
  for (const ButtonState& state : button.states()) {
    strongest_N = std::max(strongest_N, state.graph.press().forceRange_N().second);
  }
  return std::min(strongest_N, limit_N);
}

Result<FingerPlan> planOf(const FingerChoice& finger, const Button& button, const ForceDeviceProfile& device,
                          double travel_mm) {
  switch (finger.kind) {
    case FingerChoice::Kind::hold: {
      const double at_mm = finger.hold_mm.value_or(travel_mm / 2);
      if (at_mm < -1 || at_mm > travel_mm + 1) {
        return Failure{
            FailureCode::wrongUsage, "--finger hold", "",
            Message("the position lies more than 1 mm outside the travel of %1", millimetres(travel_mm)),
            Message("Give a position inside the travel")};
      }
      const double carried_N = button.states().front().graph.press().force_N(at_mm) + device.friction_N;
      return FingerPlan{FingerHold{at_mm, std::min(carried_N, device.limits.force_N), 0.4}};
    }
    case FingerChoice::Kind::press: {
      FingerPresses presses;
      presses.travel_mm = travel_mm;
      presses.force_N = strongestForce_N(button, device.limits.force_N);
      return FingerPlan{presses};
    }
    case FingerChoice::Kind::trace:
      break;
  }
  std::vector<double> times_s, values;
  for (const PressReading& r : finger.trace.readings) {
    if (!std::isfinite(r.value) || (!times_s.empty() && r.time_s <= times_s.back())) continue;
    times_s.push_back(r.time_s);
    values.push_back(r.value);
  }
  if (times_s.empty()) {
    return Failure{FailureCode::unreadableInput, "--finger", "",
                   Message("no reading of the press trace is a number"),
                   Message("Correct the times and values in the CSV file of the press")};
  }
  if (finger.trace.quantity == PressTrace::Quantity::force_N)
    return FingerPlan{FingerForcePath{times_s, values}};
  return FingerPlan{FingerPath{times_s, values}};
}

/// Measures the link. If its answers take longer than half a period, the loop runs as slowly as they arrive.
/// `computer_s`: the part that this computer causes.
Result<FittedForce> fittedToLink(const Button& button, const ForcePlayerSettings& settings, FittedForce kept,
                                 double computer_s, ForceDevice& opened) {
  const double period_s = kept.prepared.program.period_s;
  const std::optional<double> roundTrip_s = opened.measureRoundTrip_s();
  if (!roundTrip_s || !tooSlowFor(period_s, *roundTrip_s)) return kept;
  ForceDeviceProfile slower = settings.device.profile;
  const double slow_s = slowPeriod_s(period_s, *roundTrip_s);
  slower.rate_Hz = 1 / slow_s;
  slower.delay_s = std::max(slower.delay_s, slow_s);
  // Answers of such a link arrive at any time, so no part of its delay can be compensated by prediction.
  slower.jitter_s = 0.5 * slow_s + slower.late_s();
  ForceLinkPace pace;
  pace.roundTrip_s = *roundTrip_s;
  pace.requested_Hz = 1 / period_s;
  pace.computer_s = computer_s;
  Result<FittedForce> fitted = fittedTo(button, slower, settings.force, pace);
  if (!fitted) return fitted;
  if (!opened.setPace(slow_s)) {
    return Failure{FailureCode::deviceTrouble, settings.device.port, "",
                   Message("the device does not accept the limits for a slow connection"),
                   Message("Check that the firmware follows docs/reference/force-protocol.md")};
  }
  return fitted;
}

class RunningForce : public ForcePlayer {
 public:
  RunningForce(const ForcePlayerSettings& settings, FittedForce fitted, std::unique_ptr<ForceDevice> device)
      : settings_(settings),
        unheard_s_(device->longestUnheard_s()),
        summary_(std::move(fitted.prepared.summary)),
        device_(std::move(fitted.device)),
        pace_(fitted.pace),
        loop_(std::move(device), fitted.prepared.program,
              {settings.paced,
               static_cast<std::int64_t>(std::llround(settings.seconds / fitted.prepared.program.period_s)),
               settings.holdToRun}) {}

  Result<Done> takeOrders() {
    Result<std::unique_ptr<ForceOrders>> started = startForceOrders(loop_, settings_);
    if (!started) return started.failure();
    orders_ = *std::move(started);
    return Done{};
  }

  Result<Done> setButton(const Button& button) override {
    if (pace_.roundTrip_s == 0) {
      Result<PreparedForce> prepared = prepareForce(button, settings_.device.profile, settings_.force);
      if (!prepared) return prepared.failure();
      if (settings_.device.uploadTable) {
        std::optional<Failure> refused = refusedAsTable(prepared->program, device_.name);
        if (refused) return *std::move(refused);
        watchOnly(prepared->program, unheard_s_);
      } else {
        Result<FittedForce> kept =
            keptTo(settings_.device.profile, button, settings_.force, *std::move(prepared));
        if (!kept) return kept.failure();
        prepared = std::move(kept->prepared);
      }
      summary_ = std::move(prepared->summary);
      loop_.setProgram(prepared->program);
      return Done{};
    }
    ForceDeviceProfile unsoftened = device_;
    unsoftened.largestSlope_N_per_mm = settings_.device.profile.largestSlope_N_per_mm;
    Result<FittedForce> fitted = fittedTo(button, unsoftened, settings_.force, pace_);
    if (!fitted) return fitted.failure();
    summary_ = std::move(fitted->prepared.summary);
    device_ = std::move(fitted->device);
    loop_.setProgram(fitted->prepared.program);
    return Done{};
  }

  const ForceSummary& summary() const override { return summary_; }
  const ForceDeviceProfile& device() const override { return device_; }
  ForceLinkPace pace() const override { return pace_; }

  ForceStatus status() const override {
    const ForceLoopStatus from = loop_.status();
    ForceStatus to;
    to.last = from.last;
    to.steps = from.deadlines.steps;
    to.within100us = from.deadlines.within100us;
    to.missedDeadlines = from.deadlines.missed;
    to.worstLate_s = from.deadlines.worst_s;
    to.meanLate_s = from.deadlines.mean_s;
    to.realtime = from.deadlines.realtime;
    to.computerLate = from.deadlines.computerLate;
    to.deviceLate = from.deadlines.deviceLate;
    to.guard = from.guard;
    // The loop does not fade a force that the device itself makes.
    if (settings_.device.uploadTable) to.guard.faded = from.link.withdrawn;
    to.withdrawn = from.link.withdrawn;
    to.lateAnswers = from.link.late;
    to.malformedAnswers = from.link.malformed;
    to.repeatedAnswers = from.link.repeated;
    to.reconnects = from.link.reconnects;
    to.firmwareTries = from.link.firmwareTries;
    to.lowestBalance_mJ = from.lowestBalance_mJ;
    to.droppedRows = from.droppedRows;
    to.connected = from.device != ForceDeviceState::lost;
    to.homing = from.device == ForceDeviceState::homing;
    to.halt = from.halt;
    if (from.device == ForceDeviceState::fault || from.link.fault != 0)
      to.fault = english(odriveErrorWords(from.link.fault, from.link.newerFaults));
    if (from.link.clearedFault != 0)
      to.clearedFault = english(odriveErrorWords(from.link.clearedFault, from.link.newerFaults));
    to.finished = from.finished;
    return to;
  }

  void takeSteps(std::vector<ForceStep>& steps) override { loop_.takeSteps(steps); }
  void stop() override { loop_.stop(); }
  void emergencyStop() override { loop_.emergencyStop(); }
  void rearm() override { loop_.rearm(); }
  void hold(bool held) override { loop_.hold(held); }

 private:
  ForcePlayerSettings settings_;
  double unheard_s_;
  ForceSummary summary_;
  ForceDeviceProfile device_;
  ForceLinkPace pace_;
  ForceLoop loop_;
  std::unique_ptr<ForceOrders> orders_;  ///< uses the loop, so it is declared after it
};

}  // namespace

Result<std::unique_ptr<ForcePlayer>> ForcePlayer::start(const Button& button,
                                                        const ForcePlayerSettings& settings) {
  Result<PreparedForce> prepared = prepareForce(button, settings.device.profile, settings.force);
  if (!prepared) return prepared.failure();
  FingerPlan finger;
  if (settings.device.kind == ForceDeviceKind::simulated) {
    Result<FingerPlan> plan =
        planOf(settings.finger, button, settings.device.profile, prepared->summary.travel_mm);
    if (!plan) return plan.failure();
    finger = *std::move(plan);
  }
  FittedForce fitted{*std::move(prepared), settings.device.profile, {}};
  double computer_s = 0;
  // Before the device is opened, because from then on an ODrive's watchdog runs.
  if (!settings.device.uploadTable) {
    Result<FittedForce> kept =
        keptTo(settings.device.profile, button, settings.force, std::move(fitted.prepared));
    if (!kept) return kept.failure();
    fitted = *std::move(kept);
    if (!settings.device.port.empty()) computer_s = ownTerminalDelay_s();
  }
  Result<std::unique_ptr<ForceDevice>> device =
      openForceDevice(settings.device, fitted.prepared, std::move(finger));
  if (!device) return device.failure();
  // A device that runs the law itself does not depend on the link's speed.
  if (settings.device.uploadTable) {
    watchOnly(fitted.prepared.program, (*device)->longestUnheard_s());
  } else {
    Result<FittedForce> onLink = fittedToLink(button, settings, std::move(fitted), computer_s, **device);
    if (!onLink) return onLink.failure();
    fitted = *std::move(onLink);
  }
  auto running = std::make_unique<RunningForce>(settings, std::move(fitted), *std::move(device));
  if (Result<Done> orders = running->takeOrders(); !orders) return orders.failure();
  return std::unique_ptr<ForcePlayer>(std::move(running));
}

}  // namespace detent::playback
