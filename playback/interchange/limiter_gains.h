// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The limiter's gain over a press, for the exported file.

#include <cstdint>
#include <vector>

namespace detent::playback {

/// Gain in [0, 1] at a sample; linear between two points.
struct GainPoint {
  std::int64_t frame = 0;
  double gain = 1;
};

/// The gain of the limiter as few points, such that `whole` times the gain equals `limited` within
/// `tolerance` (> 0, share of full scale) at every sample. Both have the same length. Empty for no samples.
/// Any thread; allocates.
std::vector<GainPoint> limiterGains(const std::vector<float>& whole, const std::vector<float>& limited,
                                    double tolerance);

}  // namespace detent::playback
