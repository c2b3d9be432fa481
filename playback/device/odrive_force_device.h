// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A motor on an ODrive, controlled by its ASCII protocol over USB or UART. A torque on a capstan gives the
// force; ODrive's own watchdog removes it if the host is silent.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playback/device/force_device.h"
#include "playback/device/round_trips.h"
#include "playback/device/serial_link.h"

namespace detent::playback {

struct OdriveSettings {
  std::string port;
  unsigned baud = 115200;  ///< baud rate of a UART; USB ignores it
  unsigned axis = 0;       ///< 0 or 1
  double mmPerTurn =
      60;  ///< not 0; travel of the handle per turn, negative if the motor is mounted the other way round
  double force_N = 1,
         speed_mm_per_s =
             2000;  ///< > 0; limits set in the firmware: torque, and a speed beyond which it must not brake
  double watchdog_s = 0.05;  ///< the motor is switched off after this time without a command
  double period_s = 0.001;
};

class OdriveForceDevice : public ForceDevice {
 public:
  /// Opens a port; reports and clears old errors; sets everything on which the torque depends (control mode,
  /// input mode, limits, no torque from the firmware itself) and reads it back; arms the axis; then switches
  /// the watchdog on and takes the present position as rest. Failure if no ODrive answers, if a setting is
  /// not accepted (it is named), or if the axis does not arm: with its error.
  static Result<std::unique_ptr<OdriveForceDevice>> open(const OdriveSettings& settings);
  /// Removes the torque, sets the axis to idle, and restores every setting that was changed.
  ~OdriveForceDevice() override;

  /// Only one question is in flight at a time, because an ODrive's answers carry no number. An answer that
  /// arrives after its period is late, not fresh; while it is missing, nothing else is requested. An answer
  /// that was not requested is counted as repeated, never used.
  ForceReading exchange(const ForceCommand& command) override;
  std::optional<double> measureRoundTrip_s() override;
  bool setPace(double period_s) override;
  /// Clears the axis's errors, arms it anew and takes the present position as rest.
  void rearm() override;
  ForceDeviceState state() const override {
    if (!link_.isOpen()) return ForceDeviceState::lost;
    return armed_ ? ForceDeviceState::ready : ForceDeviceState::fault;
  }
  ForceLinkCounts counts() const override { return counts_; }

 private:
  OdriveForceDevice(SerialLink link, const OdriveSettings& settings)
      : link_(std::move(link)), settings_(settings), wait_s_(answerWaitOfPeriod * settings.period_s) {}
  template <class... Values>
  void say(const char* pattern, Values... values);
  void write(const char* property, double value);
  void feed();
  std::optional<std::string> askText(const char* property);
  std::optional<std::string> askAgain(const char* property);
  std::optional<double> ask(const char* property);
  std::uint64_t error();
  bool arm(double wait_s);
  bool configure();
  bool allows(double torque_Nm);
  bool hold(const char* property, double value, bool required);
  void settle();
  void disarmed();
  void askPosition();
  void askMarker();
  void noteState(double state);
  void takeArrived(double deadline_s);
  std::optional<double> feedback_turns(double deadline_s);
  std::optional<double> fedFeedback_turns();
  std::optional<double> nextPosition();
  enum class Answer : std::uint8_t { fresh, late, other };
  Answer take(std::string_view line, double& turns);

  /// A setting of the device before it was changed.
  struct Kept {
    const char* property;
    std::string text;
  };

  SerialLink link_;
  OdriveSettings settings_;
  double wait_s_;  ///< longest wait for an answer
  ForceLinkCounts counts_;
  std::vector<Kept> kept_;
  bool configured_ = false;  ///< set once: values read from now on may have been set by this program
  std::string unheld_;       ///< the setting that was not accepted, and the reason
  double rest_turns_ = 0, last_mm_ = 0, stateSent_s_ = 0;
  bool armed_ = false, olderNames_ = true, zeroLost_ = false;
  bool pending_ = false;       ///< a position was requested and has not arrived
  bool requestedNow_ = false;  ///< requested in this period
  double requested_s_ = 0;     ///< when
  /// an answer was lost or garbled: no answer counts until that of the marker has arrived
  bool unsure_ = false;
  int markersDue_ = 0;  ///< markers that were sent and not yet answered
  int numbersDue_ = 0;  ///< requested values of properties, including those of markers, that have not arrived
  double markerSent_s_ = -1e9, unsureSince_s_ = 0;
};

/// Names of an axis's error bits, for firmware 0.5 or, with `newer`, 0.6: "watchdog timer expired". A bit
/// without a name is given as a number, with a warning if the firmware may have truncated it.
Message odriveErrorWords(std::uint64_t error, bool newer);

}  // namespace detent::playback
