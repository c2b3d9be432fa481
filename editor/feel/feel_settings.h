// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The user's choices in the feel panel; no part of any button.

#include <optional>
#include <QString>
#include <QVariantMap>

#include "editor/feel/press_pad.h"
#include "playback/playback.h"

namespace detent::editor {

/// Force device and its settings. Plain value.
struct ForceChoices {
  QString
      device;  ///< as playback::forceDeviceFrom names it: "sim:falcon", "serial:/dev/ttyACM0"; empty: none
  double largest_N = 0;  ///< 0: the device's own limit
  double step_mm = 0;    ///< encoder step at the finger; 0: the device's own
  /// travel per turn of an ODrive, mm; negative if the motor is mounted the other way
  double mmPerTurn = 60;
  QString firmwareFile;  ///< firmware file of a Falcon; empty: it has received one since it was switched on
  bool upload = false;   ///< true: a serial device runs the law itself, at its own rate
  bool holds =
      false;  ///< the simulated finger rests in the middle of the travel; else it presses again and again
  /// the passivity controller adds damping if the button would give more energy than it took
  bool controller = false;

  friend bool operator==(const ForceChoices&, const ForceChoices&) = default;
};

/// Plain value. The session keeps it, the setup forms edit it.
struct FeelSettings {
  Drive drive = Drive::time;
  double full_N = 0;        ///< force of a full press; 0: a quarter more than the button's strongest force
  bool followState = true;  ///< the graph shows the state that is felt
  playback::FeedbackMode mode = playback::FeedbackMode::full;
  playback::EventPlacement placement = playback::EventPlacement::timeStamped;
  QString profileFile;    ///< empty: a perfect device
  QString referenceFile;  ///< a signal of another program to compare with; empty: none

  bool sound = true;    ///< the first press opens the device
  QString device;       ///< empty: the default output
  double rate_Hz = 0;   ///< 0: the device's own
  unsigned buffer = 0;  ///< frames; 0: the host's choice
  double gain_dB = 0;   ///< lowestGain_dB..highestGain_dB

  QString sensorPort;
  unsigned sensorBaud = 230400;

  ForceChoices force;

  friend bool operator==(const FeelSettings&, const FeelSettings&) = default;
};

inline constexpr double lowestGain_dB = -40, highestGain_dB = 20;
inline constexpr double strongestDevice_N = 100, coarsestStep_mm = 1, longestTurn_mm = 1000;
double gainOf(double dB);  ///< factor
/// Settings of the chosen sound device.
playback::PlayerSettings outputOf(const FeelSettings& settings);
/// The chosen force device; empty: none. Failure wrongUsage: an unknown kind of device.
Result<std::optional<playback::ForceDeviceChoice>> forceDeviceOf(const ForceChoices& choices);

QVariantMap toMap(const FeelSettings& settings);
/// Settings from stored values. Unknown keys are ignored; missing and impossible values become defaults.
FeelSettings feelSettingsFrom(const QVariantMap& map);

}  // namespace detent::editor
