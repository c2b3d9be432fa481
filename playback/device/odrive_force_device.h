// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A motor on an ODrive, by its ASCII protocol over USB or UART. The force is a torque on a capstan; ODrive's own watchdog takes it
// away when the host is silent.

#include <memory>
#include <string>

#include "playback/device/force_device.h"
#include "playback/device/serial_link.h"

namespace detent::playback {

struct OdriveSettings {
  std::string port;
  unsigned baud = 115200;  ///< of a UART; USB ignores it
  unsigned axis = 0;       ///< 0 or 1
  double mmPerTurn =
      60;  ///< not 0; travel of the handle per turn, negative where the motor is mounted the other way
  double watchdog_s = 0.05;  ///< the motor is off after so much silence
  double period_s = 0.001;
};

class OdriveForceDevice : public ForceDevice {
 public:
  /// Opens a port, sets torque control and the watchdog, takes the present position as rest. Trouble where no ODrive answers.
  static Result<std::unique_ptr<OdriveForceDevice>> open(const OdriveSettings& settings);
  /// No torque, then idle.
  ~OdriveForceDevice() override;

  ForceReading exchange(const ForceCommand& command) override;
  ForceDeviceState state() const override {
    return link_.isOpen() ? ForceDeviceState::ready : ForceDeviceState::lost;
  }
  ForceLinkCounts counts() const override { return counts_; }

 private:
  OdriveForceDevice(SerialLink link, const OdriveSettings& settings)
      : link_(std::move(link)), settings_(settings) {}
  void configure();
  std::optional<double> feedback_turns(double deadline_s);

  SerialLink link_;
  OdriveSettings settings_;
  ForceLinkCounts counts_;
  double rest_turns_ = 0, last_mm_ = 0;
};

}  // namespace detent::playback
