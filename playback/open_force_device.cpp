// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/open_force_device.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "playback/device/falcon_force_device.h"
#include "playback/device/falcon_protocol.h"
#include "playback/device/odrive_force_device.h"
#include "playback/device/round_trips.h"
#include "playback/device/serial_force_device.h"
#include "playback/device/simulated_device.h"
#include "playback/device/steady_clock.h"
#include "playback/realtime/direction_proof.h"
#include "playback/realtime/force_guard.h"

namespace detent::playback {

namespace {

// An answer within this share of a period does not slow down the loop.
constexpr double answerOfPeriod = 0.5;
// Allowance for the scatter of the link.
constexpr double roundTripRoom = 1.05, roundTripRoom_s = 200e-6;
// A proof of direction ends by itself; on a link without answers it ends after this time.
constexpr double longestProof_s = 5;

std::unique_ptr<ForceDevice> simulatedOn(const PreparedForce& prepared, const ForceDeviceProfile& p,
                                         FingerPlan finger) {
  SimulatedDeviceSettings s;
  s.mass_kg = p.mass_kg;
  s.friction_N = p.friction_N;
  s.damping_Ns_per_mm = p.damping_Ns_per_mm;
  s.step_mm = p.step_mm;
  s.period_s = prepared.program.period_s;
  s.delay_s = p.delay_s;
  s.lag_s = p.lag_s;
  s.force_N = p.limits.force_N;
  s.start_mm = prepared.summary.rest_mm;
  s.lowest_mm = std::min(s.lowest_mm, s.start_mm);
  return std::make_unique<SimulatedForceDevice>(s, SimulatedFinger({}, std::move(finger)));
}

Failure reversedOn(const std::string& port) {
  return {FailureCode::deviceTrouble, port, "",
          Message("the polarity is reversed: the handle moves against the commanded force"),
          Message("Swap the motor's two wires or the encoder's A and B")};
}

Failure unmovedOn(const std::string& port) {
  return {FailureCode::deviceTrouble, port, "", Message("the handle does not follow a small push"),
          Message("Turn the motor by hand: if the position does not change, the encoder is dead. Otherwise "
                  "free the handle, take the finger off, and try again")};
}

Failure irregularOn(const std::string& port, std::uint64_t missed, std::uint64_t requested) {
  return {
      FailureCode::deviceTrouble, port, "",
      Message("%1 of %2 answers were late or lost while the handle was pushed a little", missed, requested),
      Message("Check the cable, close other programs on this computer, and try again")};
}

/// Pushes the handle slightly (realtime/direction_proof.h) before a law is uploaded that the device then runs
/// itself, as slowly as the link requires. Measures the link. Failure deviceTrouble if the handle moves the
/// wrong way or not at all.
Result<Done> proveDirection(SerialForceDevice& device, const ForceProgram& program, const std::string& port) {
  const double roundTrip_s = device.measureRoundTrip_s().value_or(0);
  if (!program.proof.present) return Done{};
  const bool slow = tooSlowFor(program.period_s, roundTrip_s);
  const double period_s = slow ? slowPeriod_s(program.period_s, roundTrip_s) : program.period_s;
  if (slow) device.setPace(period_s);
  const RealtimeWhile realtime(forcePriority);
  DirectionProof proof(program.proof, period_s);
  ForceGuard guard(program.limits, period_s, program.step_mm);
  ForceCommand command;
  double due_s = now_s();
  for (const double end_s = due_s + longestProof_s;
       proof.verdict() == DirectionProof::Verdict::running && due_s < end_s;) {
    if (guard.halt() != ForceHalt::none) {  // the answers failed, not the handle
      guard.rearm();
      proof.restart();
    }
    const ForceReading reading = device.exchange(command);
    const bool good = guard.judge(reading.position_mm, reading.fresh) == ReadingVerdict::good;
    command.force_N = guard.limit(good ? proof.step_N(reading.position_mm) : 0, 0);
    due_s = std::max(due_s + period_s, now_s());
    sleepUntil(due_s);
  }
  device.exchange(ForceCommand{});
  if (slow) device.setPace(program.period_s);
  switch (proof.verdict()) {
    case DirectionProof::Verdict::agrees:
      return Done{};
    case DirectionProof::Verdict::reversed:
      return reversedOn(port);
    case DirectionProof::Verdict::unmoved:
      return unmovedOn(port);
    case DirectionProof::Verdict::running:
      break;
  }
  return irregularOn(port, guard.counts().missing, guard.counts().readings);
}

Result<std::unique_ptr<ForceDevice>> serialOn(const PreparedForce& prepared,
                                              const ForceDeviceChoice& choice) {
  Result<std::unique_ptr<SerialForceDevice>> device =
      SerialForceDevice::open(choice.port, choice.baud, prepared.program.period_s, prepared.program.limits);
  if (!device) return device.failure();
  const SerialForceInfo& info = (*device)->info();
  if (prepared.program.step_mm < info.step_mm * 0.999) {
    return Failure{FailureCode::wrongUsage,
                   choice.port,
                   "",
                   Message("the device has steps of %1, but the playback was prepared for finer steps",
                           millimetres(info.step_mm)),
                   {{RemedyKind::advice, Message("Set this encoder step and start again")},
                    {RemedyKind::advice, Message("On the command line: --step-mm %1", info.step_mm)}}};
  }
  if (choice.uploadTable) {
    if (Result<Done> proved = proveDirection(**device, prepared.program, choice.port); !proved)
      return proved.failure();
    if (Result<Done> sent = (*device)->upload(prepared.program); !sent) return sent.failure();
  }
  return std::unique_ptr<ForceDevice>(std::move(*device));
}

Result<std::unique_ptr<ForceDevice>> odriveOn(const PreparedForce& prepared,
                                              const ForceDeviceChoice& choice) {
  OdriveSettings settings;
  settings.port = choice.port;
  settings.baud = choice.baud;
  settings.axis = choice.axis;
  settings.mmPerTurn = choice.mmPerTurn;
  settings.period_s = prepared.program.period_s;
  settings.force_N = prepared.program.limits.force_N;
  settings.speed_mm_per_s = prepared.program.limits.speed_mm_per_s;
  Result<std::unique_ptr<OdriveForceDevice>> device = OdriveForceDevice::open(settings);
  if (!device) return device.failure();
  return std::unique_ptr<ForceDevice>(std::move(*device));
}

Result<std::unique_ptr<ForceDevice>> falconOn(const PreparedForce& prepared,
                                              const ForceDeviceChoice& choice) {
  FalconSettings settings;
  settings.number = choice.number;
  settings.period_s = prepared.program.period_s;
  if (!choice.firmwareFile.empty()) {
    Result<std::vector<std::uint8_t>> firmware = readFalconFirmware(choice.firmwareFile);
    if (!firmware) return firmware.failure();
    settings.firmware = *std::move(firmware);
  }
  Result<std::unique_ptr<ForceDevice>> device = openFalcon(settings);
  if (!device) return device.failure();
  return std::move(*device);
}

}  // namespace

Result<std::unique_ptr<ForceDevice>> openForceDevice(const ForceDeviceChoice& choice,
                                                     const PreparedForce& prepared, FingerPlan finger) {
  switch (choice.kind) {
    case ForceDeviceKind::simulated:
      return simulatedOn(prepared, choice.profile, std::move(finger));
    case ForceDeviceKind::serial:
      return serialOn(prepared, choice);
    case ForceDeviceKind::odrive:
      return odriveOn(prepared, choice);
    case ForceDeviceKind::falcon:
      break;
  }
  return falconOn(prepared, choice);
}

void watchOnly(ForceProgram& program, double longestUnheard_s) {
  program.proof.present = false;  // done already; from now on the device makes its force itself
  program.limits.deadCountAbove_N =
      std::numeric_limits<double>::infinity();  // no probe: this program cannot lower the device's force
  program.limits.heldReadings = static_cast<std::uint32_t>(longestUnheard_s / program.period_s) + 1;
  // the time for which the device continues without messages
  program.limits.longestHold_s = longestUnheard_s;
}

bool tooSlowFor(double period_s, double roundTrip_s) { return roundTrip_s > answerOfPeriod * period_s; }

double slowPeriod_s(double period_s, double roundTrip_s) {
  return std::max(period_s, (roundTripRoom * roundTrip_s + roundTripRoom_s) / answerOfSlowPeriod);
}

Result<std::unique_ptr<ForceOrders>> startForceOrders(ForceLoop& loop, const ForcePlayerSettings& settings) {
  ForceOrderSettings orders;
  orders.keys = settings.stopKeys;
  orders.signals = settings.stopSignals;
  orders.oscPort = settings.stopOscPort;
  orders.oscAddress = settings.stopOscAddress;
  orders.holdToRun = settings.holdToRun;
  return ForceOrders::start(loop, orders);
}

}  // namespace detent::playback
