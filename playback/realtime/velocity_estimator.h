// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Velocity from an encoder with finite steps. Three methods; docs/measurements/bench-force.md has the noise
// and delay of each.

#include <array>
#include <cstddef>
#include <cstdint>

#include "playback/realtime/force_program.h"

namespace detent::playback {

/// One axis, called once per period. No allocation, lock, clock or exception.
class VelocityEstimator {
 public:
  /// `period_s`, `step_mm` > 0.
  VelocityEstimator(VelocityMethod method, double period_s, double step_mm);

  /// Discards the history; at rest at a position.
  void restart(double position_mm);

  /// Velocity in mm/s after the next reading.
  double update(double position_mm);

 private:
  static constexpr std::size_t foawWindow =
      15;  ///< longest window in samples; recommended by Janabi-Sharifi, Hayward and Chen 2000
  double kalman(double position_mm);
  double foaw(double position_mm);
  double boundedByStep(double velocity_mm_per_s) const;

  VelocityMethod method_;
  double period_s_, step_mm_;
  double positionGain_ = 0, velocityGain_per_s_ = 0;
  double estimate_mm_ = 0, velocity_mm_per_s_ = 0;
  double last_mm_ = 0;
  std::uint32_t unchanged_ = 0;  ///< readings since the position last changed
  std::array<double, foawWindow + 1> history_mm_{};
  std::size_t newest_ = 0, kept_ = 0;
};

}  // namespace detent::playback
