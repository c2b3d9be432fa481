// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Counts complete presses: to the end of the travel and back. A study counts a button with such a press as
// felt.

#include <cstdint>

#include "playback/realtime/haptic_program.h"
#include "playback/realtime/stroke_tracker.h"

namespace detent::playback {

/// Presses of a finger during a period of time.
struct PressCount {
  std::uint64_t begun = 0;  ///< presses that left the top
  /// those of these presses that reached the bottom-out (without one: 95 % of the travel) and came back
  std::uint64_t whole = 0;
  double peak_N = 0;     ///< strongest force while away from the top
  double travel_mm = 0;  ///< deepest position, measured from the start of the press stroke
};

/// Counts presses from the positions of a tracker. A finger that is down when a program is exchanged must
/// come up first: that press belongs to the previous program. One thread; no allocation.
class PressCounter {
 public:
  /// `program` must outlive its use here; nullptr: counts nothing.
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
