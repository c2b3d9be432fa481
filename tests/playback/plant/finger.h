// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Movements of a finger as plans for handle.h. Each is a function of time alone.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/playback/plant/handle.h"

namespace detent::test {

/// 0 before, 1 after, smooth between.
inline double eased(double time_s, double from_s, double duration_s) {
  const double share = std::clamp((time_s - from_s) / duration_s, 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

/// Presses to an aim and comes back, `down_s` each way, with a rest between; again every `every_s` (0: once).
struct Presses {
  double from_mm = -1, to_mm = 6;
  double push_N = 0;  ///< on top, at the bottom
  double wait_s = 0.3, down_s = 0.1, rest_s = 0.1, up_s = 0.1, every_s = 0;
};
inline Plan pressing(const Presses& p) {
  return [p](double time_s) {
    double t = time_s;
    if (p.every_s > 0 && t >= p.wait_s) t = p.wait_s + std::fmod(t - p.wait_s, p.every_s);
    const double share = eased(t, p.wait_s, p.down_s) - eased(t, p.wait_s + p.down_s + p.rest_s, p.up_s);
    return Intent{p.from_mm + (p.to_mm - p.from_mm) * share, p.push_N * share};
  };
}

/// Aims at a place and carries a force there.
inline Plan holding(double at_mm, double push_N = 0) {
  return [at_mm, push_N](double) { return Intent{at_mm, push_N}; };
}

/// The weight of a finger that lies on the button.
inline Plan resting(double weight_N, double at_mm = 0) { return holding(at_mm, weight_N); }

/// Holds, then draws back as fast as muscles do.
inline Plan lettingGo(double at_mm, double push_N, double after_s) {
  return [=](double time_s) {
    const double gone = eased(time_s, after_s, 0.05);
    return Intent{at_mm - 30 * gone, push_N * (1 - gone)};
  };
}

/// Follows a straight line at a speed from a time on.
inline Plan sweeping(double from_mm, double speed_mm_per_s, double after_s = 0) {
  return [=](double time_s) { return Intent{from_mm + speed_mm_per_s * std::max(0.0, time_s - after_s), 0}; };
}

}  // namespace detent::test
