// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One press of one finger on one button, in steps of 50 µs (docs/reference/press-forecast.md, "Plant").
// Lengths in m, downwards.

#include <array>
#include <optional>
#include <vector>

#include "playback/performance/fingers.h"
#include "playback/performance/key_tables.h"

namespace detent::playback {

inline constexpr double plantStep_s = 5e-5;    ///< 20 kHz
inline constexpr double mostAmplitude_N = 30;  ///< largest amplitude that a finger commands
inline constexpr double longestPress_s = 0.5;  ///< time after which a press counts as not ended
inline constexpr double extensorOfAmplitude = 0.6;
inline constexpr double capMass_kg = 0.002;
inline constexpr double rapidTravel_m = 0.0002;  ///< distance at which a rapid trigger opens and closes

/// Command to the finger.
struct PressCommand {
  double amplitude_N = 1;  ///< amplitude of the flexor, > 0
  double duration_s = 0.08;
  /// time from the end of the flexor's pulse to the start of the extensor's; may be negative
  double lift_s = 0;
};

/// Result of a press. Times count from the start of the command.
struct PressOutcome {
  std::optional<double> touch_s, activation_s, opening_s, rapidOpening_s;
  int closings = 0, rapidClosings = 0;
  double peak_N = 0;  ///< largest force between fingertip and cap
  double peak_s = 0;
  double impulse_Ns = 0;  ///< time integral of the contact force
  double deepest_m = 0;
  double end_s = longestPress_s;
  bool ended = false;
};

/// Energy balance of a press, J. The muscle supplies what is stored and dissipated.
struct PressEnergy {
  double muscle_J = 0;     ///< work of flexor and extensor on the finger
  double taken_J = 0;      ///< dissipated by dampers and play
  double stored_J = 0;     ///< energy in motion, pulp, posture spring and button, minus the initial energy
  double moved_J = 0;      ///< sum of the absolute works: the scale for errors
  double playTaken_J = 0;  ///< part of `taken_J` due to play
};

/// Simulates one press. Deterministic; any thread. `energy`: receives the energy balance, if not null.
bool closesContact(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                   const PressCommand& command);  ///< the same press, simulated only up to its contact
PressOutcome simulatePress(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                           const PressCommand& command, PressEnergy* energy = nullptr);
/// Simulates two presses of one finger in little more time than one (lanes.h); the results equal those of
/// single simulations.
std::array<PressOutcome, 2> simulatePresses(const KeyTables& key, const ContactPoints& contact,
                                            const Finger& finger,
                                            const std::array<PressCommand, 2>& commands);
/// Depth of the cap after each step of the same press, m.
std::vector<double> depthsOfPress(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                                  const PressCommand& command);

}  // namespace detent::playback
