// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/velocity_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace detent::playback {

namespace {

// Typical acceleration of a finger, 3 m/s^2: the standard deviation of the acceleration within one press of
// 100 ms. A factor of three in either direction costs 10 to 30 % in error (docs/measurements/bench-force.md).
constexpr double fingerAcceleration_mm_per_s2 = 3000;

}  // namespace

VelocityEstimator::VelocityEstimator(VelocityMethod method, double period_s, double step_mm)
    : method_(method), period_s_(period_s), step_mm_(step_mm) {
  // Steady-state Kalman gains for a random acceleration (Kalata's tracking index). An encoder step is uniform
  // noise.
  const double readingNoise_mm = step_mm / std::sqrt(12.0);
  const double index = fingerAcceleration_mm_per_s2 * period_s * period_s / readingNoise_mm;
  const double r = (4 + index - std::sqrt(8 * index + index * index)) / 4;
  positionGain_ = 1 - r * r;
  velocityGain_per_s_ = (2 * (2 - positionGain_) - 4 * std::sqrt(1 - positionGain_)) / period_s;
}

void VelocityEstimator::restart(double position_mm) {
  estimate_mm_ = last_mm_ = position_mm;
  velocity_mm_per_s_ = 0;
  unchanged_ = 0;
  newest_ = 0;
  kept_ = 1;
  history_mm_[0] = position_mm;
}

double VelocityEstimator::update(double position_mm) {
  unchanged_ = position_mm != last_mm_                                  ? 0
               : unchanged_ < std::numeric_limits<std::uint32_t>::max() ? unchanged_ + 1
                                                                        : unchanged_;
  double velocity_mm_per_s = 0;
  switch (method_) {
    case VelocityMethod::kalman:
      velocity_mm_per_s = boundedByStep(kalman(position_mm));
      break;
    case VelocityMethod::foaw:
      velocity_mm_per_s = foaw(position_mm);
      break;
    case VelocityMethod::difference:
      velocity_mm_per_s = (position_mm - last_mm_) / period_s_;
      break;
  }
  last_mm_ = position_mm;
  return velocity_mm_per_s;
}

double VelocityEstimator::kalman(double position_mm) {
  estimate_mm_ += velocity_mm_per_s_ * period_s_;
  const double miss_mm = position_mm - estimate_mm_;
  estimate_mm_ += positionGain_ * miss_mm;
  velocity_mm_per_s_ += velocityGain_per_s_ * miss_mm;
  return velocity_mm_per_s_;
}

// While no new step arrives, the speed cannot exceed one step divided by that time. Without this bound, an
// estimator keeps a velocity at rest (SimpleFOC issue 533). The filter's state is not changed.
double VelocityEstimator::boundedByStep(double velocity_mm_per_s) const {
  if (unchanged_ == 0) return velocity_mm_per_s;
  const double bound_mm_per_s = step_mm_ / (unchanged_ * period_s_);
  return std::clamp(velocity_mm_per_s, -bound_mm_per_s, bound_mm_per_s);
}

// First-order adaptive windowing, end-fit: the longest window in which every reading lies within one step of
// the line through its ends.
double VelocityEstimator::foaw(double position_mm) {
  const std::size_t slots = history_mm_.size();
  newest_ = (newest_ + 1) % slots;
  history_mm_[newest_] = position_mm;
  kept_ = std::min(kept_ + 1, slots);
  double velocity_mm_per_s = 0;
  for (std::size_t window = 1; window < kept_; ++window) {
    const double slope_mm =
        (position_mm - history_mm_[(newest_ + slots - window) % slots]) / static_cast<double>(window);
    bool straight = true;
    for (std::size_t i = 1; i < window && straight; ++i) {
      const double line_mm = position_mm - slope_mm * static_cast<double>(i);
      straight = std::abs(history_mm_[(newest_ + slots - i) % slots] - line_mm) <= step_mm_;
    }
    if (!straight) break;
    velocity_mm_per_s = slope_mm / period_s_;
  }
  return velocity_mm_per_s;
}

}  // namespace detent::playback
