// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Counts complete presses: to the end of the travel and back. A study counts these as felt.

#include <cstdint>

#include "playback/realtime/haptic_program.h"
#include "playback/realtime/stroke_tracker.h"

namespace detent::playback {

/// Presses of a finger over a stretch of time.
struct PressCount {
  std::uint64_t begun = 0;  ///< left the top
  std::uint64_t whole =
      0;              ///< of those, went to the bottom-out (without one: to 95 % of the travel) and came back
  double peak_N = 0;  ///< strongest force while away from the top
  double travel_mm = 0;  ///< deepest place, from where the press stroke begins
};

/// Counts presses from the positions a tracker gives. A finger that is down when a program comes under it has
/// to come up first: that press belongs to the program before. One thread; no allocation.
class PressCounter {
 public:
  /// `program` must outlive its use here; nullptr: nothing is counted.
  void use(const HapticProgram* program);
  void take(const StrokePosition& position);
  /// Presses since the last call.
  PressCount taken();

 private:
  enum class Phase : std::uint8_t { notYetUp, up, down, through };

  const HapticProgram* program_ = nullptr;
  Phase phase_ = Phase::notYetUp;
  PressCount count_;
};

}  // namespace detent::playback
