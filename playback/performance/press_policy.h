// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The command with which one finger presses one button at the least cost, and its results over the finger's
// noise (docs/reference/press-forecast.md, "Fingers" and "Policy").

#include <optional>
#include <vector>

#include "playback/performance/press_plant.h"

namespace detent::playback {

/// Properties of a button that the policy needs.
struct PressTask {
  ContactPoints contact;
  bool jumpIsFelt = false;
  std::optional<double> period_s;  ///< period of a paced task: the mean cycle must fit into it; > 0
};

/// Means over the noise of one finger. Shares in 0..1, times in s.
struct PressStatistics {
  double peak_N = 0, impulse_Ns = 0;
  double activation_s = 0, activationSpread_s = 0;  ///< times from the first touch
  double commandToActivation_s = 0, commandToActivationSpread_s = 0;
  double impactSpread_s = 0;  ///< standard deviation of the time from the command to the peak force
  double cycle_s = 0;         ///< command to end of press
  /// time from activation to the opening of the contact: at the button's reset point, and by rapid trigger
  double held_s = 0, rapidHeld_s = 0;
  double missed = 0, doubled = 0, rapidDoubled = 0;
};

/// The plan of one finger and its results.
struct FingerPlan {
  PressCommand command;
  PressStatistics result;
  double accidental = 0;         ///< share of resting fingers that activate the button
  double highestRate_per_s = 0;  ///< highest rate with at most 5 % misses and 5 % doubles; 0: not reachable
  double timePerCorrectPress_s = 0;
};

/// Standard deviation (N) of the amplitudes of a finger whose intended amplitude is `amplitude_N`.
double amplitudeSpread_N(const Finger& finger, double amplitude_N);

/// Empty if no allowed command activates the contact, or if none fits the period.
std::optional<FingerPlan> planPress(const KeyTables& key, const Finger& finger, const PressTask& task);

}  // namespace detent::playback
