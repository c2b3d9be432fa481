// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A key of a magnetic keyboard as its firmware evaluates it: with fixed points, or with rapid trigger, which
// follows the direction of the movement. The terms mean what they mean in public firmware: distances and
// "continuous" as in libhmk (src/matrix.c), minipad-firmware (keypad_handler.cpp) and Wooting's guide to
// rapid trigger; dead zones as in Cipulot's and byungyoonc's QMK for Hall sensors (he_switch_matrix.c). No
// code is theirs.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/button.h"
#include "model/result.h"

namespace detent::playback {

/// Distances of rapid trigger, both > 0. It begins when the key closes at the actuation point.
struct RapidTrigger {
  /// distance from the highest place since the key opened, downwards, at which it closes again
  double press_mm = 0.1;
  /// distance from the deepest place since the key closed, upwards, at which it opens
  double release_mm = 0.1;
  /// Stays active until the key is fully released (top dead zone, or rest), so that the key also closes above
  /// the actuation point; else ends at the release point, and the key closes only below the actuation point.
  bool continuous = false;

  friend bool operator==(const RapidTrigger&, const RapidTrigger&) = default;
};

/// "off", "0.1 mm", or "0.1/0.2 mm" where the distances of press and release differ.
std::string textOf(const std::optional<RapidTrigger>& rapid);

/// Settings of one key. Displacements from rest.
struct MagneticKeySettings {
  double actuate_mm = 2, reset_mm = 1.8;  ///< the reset point lies above the actuation point
  std::optional<RapidTrigger> rapid;
  double topDeadZone_mm = 0;     ///< from rest: the key is open, whatever else is set
  double bottomDeadZone_mm = 0;  ///< before the end of the travel: the key is closed, whatever else is set
  double travel_mm = std::numeric_limits<double>::infinity();
  double scan_s = 0.001;  ///< > 0

  /// Returns true if the settings are more than one distance of the rapid trigger for both directions. The C
  /// header and the JSON then have further fields.
  bool beyondOneDistance() const {
    return topDeadZone_mm > 0 || bottomDeadZone_mm > 0 ||
           (rapid && (rapid->continuous || rapid->press_mm != rapid->release_mm));
  }
};

/// Settings of a key that acts at `actuate_mm`, without rapid trigger: its release point lies as far above as
/// the state's reset point above its operating point; 0.1 mm where the state lacks one, or both are one.
MagneticKeySettings settingsFor(const ButtonState& state, double actuate_mm);

/// Failure wrongUsage about the setting that contradicts another or the travel, with what to set instead.
Result<Done> checked(const MagneticKeySettings& settings);

/// One key, which receives its displacement once per scan.
class MagneticKey {
 public:
  /// `settings` as `checked` accepts them.
  explicit MagneticKey(const MagneticKeySettings& settings) : settings_(settings) {}

  /// Returns true if the key has just closed.
  bool follow(double displacement_mm);
  bool closed() const { return closed_; }

 private:
  double rapidEnds_mm() const;
  bool shouldClose(double displacement_mm) const;
  bool shouldOpen(double displacement_mm) const;

  MagneticKeySettings settings_;
  bool closed_ = false;
  bool rapidActive_ = false;
  double turn_mm_ = 0;  ///< deepest since it closed, highest since it opened
};

/// A key closing or opening during a movement.
struct KeyEvent {
  double path_mm = 0, displacement_mm = 0;  ///< path: distance moved since the beginning
  bool closes = false;
};
/// Events of a key that moves from each of `turns_mm` straight to the next, in steps of a micrometre, in
/// `largestLeg_steps` where a leg is longer.
std::vector<KeyEvent> eventsAlong(const std::vector<double>& turns_mm, const MagneticKeySettings& settings);
inline constexpr int largestLeg_steps = 100'000;

}  // namespace detent::playback
