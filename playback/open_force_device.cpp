// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/open_force_device.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "playback/device/falcon_force_device.h"
#include "playback/device/falcon_protocol.h"
#include "playback/device/odrive_force_device.h"
#include "playback/device/serial_force_device.h"
#include "playback/device/simulated_device.h"

namespace detent::playback {

namespace {

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

Result<std::unique_ptr<ForceDevice>> serialOn(const PreparedForce& prepared,
                                              const ForceDeviceChoice& choice) {
  Result<std::unique_ptr<SerialForceDevice>> device =
      SerialForceDevice::open(choice.port, choice.baud, prepared.program.period_s, prepared.program.limits);
  if (!device) return device.failure();
  const SerialForceInfo& info = (*device)->info();
  if (prepared.program.step_mm < info.step_mm * 0.999) {
    return Failure{
        FailureCode::wrongUsage, choice.port, "",
        Message("the device has steps of %1; it was prepared for finer ones", millimetres(info.step_mm)),
        Message("Give --step-mm %1", info.step_mm)};
  }
  if (choice.uploadTable) {
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

// An answer that comes within this share of a period does not slow the loop down.
constexpr double answerOfPeriod = 0.5;
// The link's own scatter.
constexpr double roundTripRoom = 1.05, roundTripRoom_s = 50e-6;

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
