// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Force feedback, as playback offers it to other rooms: press a button and feel its force, or watch a
// simulated finger do so.
//
// Reading order:
//   prepare/force_device_profile.h  limits and dynamics of a device
//   prepare/prepare_force.h         button -> program
//   realtime/force_engine.h         one step of the loop
//   this file                       running it
// Threads: as for playback.h, ordinary threads only. Built without devices (DETENT_WITH_DEVICE=OFF),
// ForcePlayer answers deviceTrouble.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/result.h"
#include "playback/identification/identify_motion.h"
#include "playback/measurement/force_profile_file.h"
#include "playback/offline/press_files.h"
#include "playback/prepare/prepare_force.h"
#include "playback/prepare/spring_button.h"
#include "playback/prepare/stability.h"
#include "playback/realtime/force_engine.h"

namespace detent::playback {

enum class ForceDeviceKind : std::uint8_t { simulated, serial, odrive, falcon };

/// A device by its name on the command line and in Setup: "sim", "sim:falcon", "sim:rig", "serial:PORT",
/// "odrive:PORT", "falcon", "falcon:N".
struct ForceDeviceChoice {
  ForceDeviceKind kind = ForceDeviceKind::simulated;
  std::string port;        ///< port of serial and odrive
  unsigned baud = 230400;  ///< rate of serial and odrive; USB ignores it
  unsigned axis = 0;       ///< axis of an ODrive
  double mmPerTurn =
      60;  ///< travel per turn of an ODrive's capstan; negative if the motor is mounted the other way round
  bool uploadTable = false;  ///< serial: the microcontroller runs the law at its own rate
  unsigned number = 0;       ///< index among several Falcons
  std::string firmwareFile;  ///< firmware of a Falcon; empty: it has received one since it was switched on
  ForceDeviceProfile profile;
};
/// Failure: wrongUsage with the words that are known.
Result<ForceDeviceChoice> forceDeviceFrom(const std::string& text);

/// Behaviour of the simulated finger; for simulated devices only.
struct FingerChoice {
  enum class Kind : std::uint8_t { hold, press, trace };
  Kind kind = Kind::press;
  std::optional<double> hold_mm;  ///< none: in the middle of the travel
  PressTrace trace;               ///< intended positions, or forces
};
/// "hold", "hold=X" (mm), "press", or the name of a press trace. Failure: wrongUsage, or what is wrong with
/// the file.
Result<FingerChoice> fingerFrom(const std::string& text);

struct ForcePlayerSettings {
  ForceDeviceChoice device;
  ForceSettings force;
  FingerChoice finger;
  double seconds = 0;        ///< 0: until stopped
  bool paced = true;         ///< false: a simulated device runs as fast as it can
  bool holdToRun = false;    ///< force only while a person holds: `hold`, the space bar, OSC /detent/hold
  bool stopKeys = false;     ///< keys of the terminal stop and arm (docs/guide/force-feedback.md)
  bool stopSignals = false;  ///< SIGUSR1 stops; signals that end the program stop at once, too
  std::optional<std::uint16_t> stopOscPort;  ///< OSC /detent/stop stops; 0: the system chooses
  std::string stopOscAddress = "127.0.0.1";
};

/// A snapshot for displays; counts since the start.
struct ForceStatus {
  ForceStep last;
  // Punctuality of the loop: the delay of steps after their scheduled times.
  std::uint64_t steps = 0, within100us = 0, missedDeadlines = 0;
  double worstLate_s = 0, meanLate_s = 0;
  std::uint64_t computerLate = 0,
                deviceLate = 0;  ///< missing answers, of steps that began late and of steps on time
  bool realtime = false;
  ForceGuardCounts guard;
  /// times the device, which runs the law itself, was commanded to give no force because its answers
  /// stopped
  std::uint64_t withdrawn = 0;
  std::uint64_t lateAnswers = 0, malformedAnswers = 0, repeatedAnswers = 0, reconnects = 0, firmwareTries = 0;
  /// lowest balance of the passivity observer; below 0: the button gave more energy than it had stored
  double lowestBalance_mJ = 0;
  std::uint64_t droppedRows = 0;
  bool connected = true;
  bool homing = false;               ///< the person has to move the handle all the way out and in
  ForceHalt halt = ForceHalt::none;  ///< reason why there is no force until a person arms or holds
  std::string clearedFault;          ///< an error of the device that was found and cleared
  std::string fault;                 ///< fault by which the device prevents force; empty: none
  bool finished = false;
};

/// Pace that the link allows; all 0 if it is as fast as the device was prepared for.
struct ForceLinkPace {
  double roundTrip_s = 0;   ///< measured: nine of ten answers take no longer
  double requested_Hz = 0;  ///< requested rate
  double computer_s = 0;    ///< part of the round trip that this computer causes
  double addedDamping_Ns_per_mm = 0,
         /// changes that the button needed because of the link, besides limited slopes
      largestForceChange_N = 0;
};

/// Measures the device itself: with no finger on it, and the handle free to move.
struct DeviceMeasurementSettings {
  ForcePlayerSettings
      run;  ///< device, rate, pace and stops; finger, seconds and the law's settings are ignored
  /// 4..80; the handle moves between 0 and this, and beyond by a few millimetres at most
  double range_mm = 10;
  double largest_N = 1;  ///< > 0, not above the device's limit
};
struct DeviceMeasurement {
  ForceDeviceMeasurement device;
  MotionIdentification motion;
  MotionRecord record;        ///< the record that was evaluated, for plots
  double roundTrip_s = 0;     ///< round trip of the link to the device; 0: there is none, or it is fast
  double longestPause_s = 0;  ///< longest pause of this computer; samples during a pause are not evaluated
};
/// Takes some ten seconds. Calls `onward` often with the completed share (0..1); false cancels. Failure:
/// wrongUsage; deviceTrouble if the device cannot be opened, does not move, or moves the other way;
/// unreadableInput if its movement does not determine the parameters.
Result<DeviceMeasurement> measureForceDevice(const DeviceMeasurementSettings& settings,
                                             const std::function<bool(double done)>& onward);

/// A button under a finger. Destroying it lets the force fall to nothing within 10 ms and joins its thread.
class ForcePlayer {
 public:
  /// Failure: wrongUsage for invalid settings, deviceTrouble if the device cannot be used.
  static Result<std::unique_ptr<ForcePlayer>> start(const Button& button,
                                                    const ForcePlayerSettings& settings);
  virtual ~ForcePlayer() = default;

  /// Exchanges the button under the finger.
  virtual Result<Done> setButton(const Button& button) = 0;
  /// Properties of the button that the device cannot render, its slope limit, and its play radius.
  virtual const ForceSummary& summary() const = 0;
  /// The device for which the force was prepared: with a slow link its rate and delay are the measured ones.
  virtual const ForceDeviceProfile& device() const = 0;
  virtual ForceLinkPace pace() const = 0;
  virtual ForceStatus status() const = 0;
  /// Appends every step since the last call, in order.
  virtual void takeSteps(std::vector<ForceStep>& steps) = 0;
  virtual void stop() = 0;

  /// Removes the force within 15 ms, until `rearm`. Any thread; returns at once.
  virtual void emergencyStop() = 0;
  /// Called when a person wants force again after an emergency stop, a fault, or a lost position: it
  /// increases from zero.
  virtual void rearm() = 0;
  /// Hold-to-run: must be called again at least every 0.1 s.
  virtual void hold(bool held) = 0;
};

}  // namespace detent::playback
