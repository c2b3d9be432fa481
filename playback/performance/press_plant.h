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
inline constexpr double mostAmplitude_N = 30;  ///< that a finger commands
inline constexpr double longestPress_s = 0.5;  ///< after which a press counts as not ended
inline constexpr double extensorOfAmplitude = 0.6;
inline constexpr double capMass_kg = 0.002;
inline constexpr double rapidTravel_m = 0.0002;  ///< by which a rapid trigger opens and closes

/// Command to the finger.
struct PressCommand {
  double amplitude_N = 1;  ///< of the flexor, > 0
  double duration_s = 0.08;
  double lift_s = 0;  ///< from the flexor's end to the extensor's start; may be negative
};

/// Result of a press. Times count from the start of the command.
struct PressOutcome {
  std::optional<double> touch_s, activation_s, opening_s, rapidOpening_s;
  int closings = 0, rapidClosings = 0;
  double peak_N = 0;  ///< of the force between fingertip and cap
  double peak_s = 0;
  double impulse_Ns = 0;  ///< of that force
  double deepest_m = 0;
  double end_s = longestPress_s;
  bool ended = false;
};

/// Balance of the energy of a press, J. The muscle gave everything that is not stored or taken.
struct PressEnergy {
  double muscle_J = 0;     ///< work of flexor and extensor on the finger
  double taken_J = 0;      ///< by dampers and play
  double stored_J = 0;     ///< in motion, pulp, posture spring and button, beyond what was there at the start
  double moved_J = 0;      ///< sum of the absolute works: what an error is measured against
  double playTaken_J = 0;  ///< the part the play took
};

/// Presses once. Deterministic; any thread. `energy`: balance of energies, if not null.
bool closesContact(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                   const PressCommand& command);  ///< the same press, only as far as its contact
PressOutcome simulatePress(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                           const PressCommand& command, PressEnergy* energy = nullptr);
/// Two presses of one finger in the time of little more than one (lanes.h); the same as one after the other.
std::array<PressOutcome, 2> simulatePresses(const KeyTables& key, const ContactPoints& contact,
                                            const Finger& finger,
                                            const std::array<PressCommand, 2>& commands);
/// Depth of the cap after each step of the same press, m.
std::vector<double> depthsOfPress(const KeyTables& key, const ContactPoints& contact, const Finger& finger,
                                  const PressCommand& command);

}  // namespace detent::playback
