// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/real_device_options.h"

#include <CLI/CLI.hpp>

namespace detent::playback {

void RealDeviceOptions::applyTo(ForceDeviceChoice& device) const {
  if (baud != 0) device.baud = baud;
  device.firmwareFile = firmwareFile;
  device.axis = axis;
  device.mmPerTurn = mmPerTurn;
  if (step_mm != 0) device.profile.step_mm = step_mm;
  if (largest_N) device.profile.limits.force_N = *largest_N;
}

void addForceDeviceOptions(CLI::App& app, RealDeviceOptions& o, const char* largestForce) {
  app.add_option("--step-mm", o.step_mm, "Encoder step at the finger in mm; 0: the profile's or preset's")
      ->capture_default_str()
      ->group(realDeviceGroup);
  app.add_option("--max-N", o.largest_N, largestForce)->group(realDeviceGroup);
  app.add_option("--firmware", o.firmwareFile,
                 "Firmware file of a Falcon that was just switched on, from its driver")
      ->group(realDeviceGroup);
  app.add_option("--axis", o.axis, "Axis of an ODrive, 0 or 1")
      ->capture_default_str()
      ->group(realDeviceGroup);
  app.add_option("--mm-per-turn", o.mmPerTurn,
                 "Handle travel per turn of an ODrive; negative if pressing turns backwards")
      ->capture_default_str()
      ->group(realDeviceGroup);
}

void addRealDeviceOptions(CLI::App& app, RealDeviceOptions& o, const char* largestForce) {
  addForceDeviceOptions(app, o, largestForce);
  app.add_option("--baud", o.baud, "Baud rate of a serial port; 0: 230400, an ODrive's 115200")
      ->capture_default_str()
      ->group(realDeviceGroup);
}

Failure fastNeedsSimulation() {
  return {FailureCode::wrongUsage, "--fast", "", "only simulated devices have a time of their own",
          "Leave it out, or use --device sim"};
}

}  // namespace detent::playback
