// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A motor on an ODrive, by its ASCII protocol over USB or UART. The force is a torque on a capstan; ODrive's own watchdog takes it
// away when the host is silent.

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
  /// Opens a port, reports and clears old errors, sets everything the torque depends on (control mode, input mode, limits, no torque of the
  /// firmware's own) and reads it back, arms the axis, then switches the watchdog on, and takes the present position as rest. Failure where no
  /// ODrive answers, a setting does not hold (it is named), or the axis does not arm: with its error.
  static Result<std::unique_ptr<OdriveForceDevice>> open(const OdriveSettings& settings);
  /// No torque, idle, and every setting that was changed as it was before.
  ~OdriveForceDevice() override;

  /// One question is in flight at a time, because an ODrive's answers carry no number: an answer that comes after its period is late, not
  /// fresh, and while it is pending nothing else is requested. An answer that nobody requested is counted as repeated,
  /// never used.
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

  /// A setting of the device as it was before.
  struct Kept {
    const char* property;
    std::string text;
  };

  SerialLink link_;
  OdriveSettings settings_;
  double wait_s_;  ///< for an answer
  ForceLinkCounts counts_;
  std::vector<Kept> kept_;
  bool configured_ = false;  ///< once: what is read from now on may be this program's own
  std::string unheld_;       ///< the setting that does not hold, and how
  double rest_turns_ = 0, last_mm_ = 0, stateSent_s_ = 0;
  bool armed_ = false, olderNames_ = true, zeroLost_ = false;
  bool pending_ = false;       ///< a position is on its way
  bool requestedNow_ = false;  ///< requested in this period
  double requested_s_ = 0;     ///< when
  bool unsure_ = false;        ///< an answer was lost or garbled: none counts until the marker has come
  int markersDue_ = 0;         ///< sent and not answered
  int numbersDue_ = 0;  ///< values of properties, the marker's too, that were asked for and have not come
  double markerSent_s_ = -1e9, unsureSince_s_ = 0;
};

/// Names of an axis's error bits, of firmware 0.5 or, `newer`, 0.6: "watchdog timer expired"; bits without a name as a number, with a
/// warning where the firmware may have cut it.
Message odriveErrorWords(std::uint64_t error, bool newer);

}  // namespace detent::playback
