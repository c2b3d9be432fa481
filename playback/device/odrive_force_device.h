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
  double force_N = 1,
         speed_mm_per_s =
             2000;  ///< > 0; the firmware's own limits: of torque, and of a speed it must not brake below
  double watchdog_s = 0.05;  ///< the motor is off after so much silence
  double period_s = 0.001;
};

class OdriveForceDevice : public ForceDevice {
 public:
  /// Opens a port, tells and clears old errors, sets torque control, arms the axis, then switches the watchdog on, and takes the present
  /// position as rest. Failure where no ODrive answers, or the axis does not arm: with its error.
  static Result<std::unique_ptr<OdriveForceDevice>> open(const OdriveSettings& settings);
  /// No torque, then idle.
  ~OdriveForceDevice() override;

  ForceReading exchange(const ForceCommand& command) override;
  std::optional<double> measureRoundTrip_s() override;
  bool setPace(double period_s, double wait_s) override;
  /// Clears the axis's errors, arms it anew and takes the present position as rest.
  void rearm() override;
  ForceDeviceState state() const override {
    if (!link_.isOpen()) return ForceDeviceState::lost;
    return armed_ ? ForceDeviceState::ready : ForceDeviceState::fault;
  }
  ForceLinkCounts counts() const override { return counts_; }

 private:
  OdriveForceDevice(SerialLink link, const OdriveSettings& settings)
      : link_(std::move(link)), settings_(settings), wait_s_(settings.period_s / 2) {}
  template <class... Values>
  void say(const char* pattern, Values... values);
  void write(const char* property, double value);
  void feed();
  std::optional<double> ask(const char* property, double wait_s);
  std::uint64_t error();
  bool arm(double wait_s);
  void limit();
  void disarmed();
  void follow(std::string_view line);
  std::optional<double> feedback_turns(double deadline_s);
  std::optional<double> nextFeedback_turns(double deadline_s);

  SerialLink link_;
  OdriveSettings settings_;
  double wait_s_;  ///< for an answer
  ForceLinkCounts counts_;
  double rest_turns_ = 0, last_mm_ = 0, asked_s_ = 0;
  bool armed_ = false, olderNames_ = true, zeroLost_ = false;
};

/// Names of an axis's error bits: "watchdog timer expired"; the number alone where none is known.
Message odriveErrorWords(std::uint64_t error);

}  // namespace detent::playback
