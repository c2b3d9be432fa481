// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Programs under a finger: a button's program and, for a button that depends on speed, a program for each of
// a series of speeds. Built by playback/prepare/prepare_speeds.h, selected by speed_tracker.h.

#include <cmath>
#include <utility>
#include <vector>

#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// The button at one speed.
struct SpeedProgram {
  double speed_mm_per_s = 0;
  HapticProgram program;
};

struct LiveProgram {
  HapticProgram program;             ///< program of the graph in front, by which speeds are measured
  std::vector<SpeedProgram> speeds;  ///< by rising speed; empty: `program` plays at any speed

  LiveProgram(const HapticProgram& only) : program(only) {}  // NOLINT(google-explicit-constructor)
  LiveProgram(const HapticProgram& front, std::vector<SpeedProgram> others)
      : program(front), speeds(std::move(others)) {}
};

/// The program nearest to a speed; `speeds` not empty.
inline const SpeedProgram& nearest(const std::vector<SpeedProgram>& speeds, double speed_mm_per_s) {
  const SpeedProgram* best = &speeds.front();
  for (const SpeedProgram& s : speeds)
    if (std::fabs(s.speed_mm_per_s - speed_mm_per_s) < std::fabs(best->speed_mm_per_s - speed_mm_per_s))
      best = &s;
  return *best;
}

}  // namespace detent::playback
