// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Largest gain reduction of a press by the limiter, for the exported file.

#include <cstdint>
#include <vector>

namespace detent::playback {

/// Gain in [0, 1] at a sample; straight between two of them.
struct GainPoint {
  std::int64_t frame = 0;
  double gain = 1;
};

/// The gain of the limiter as few points that turn `whole` into `limited` within `tolerance` (> 0, share of
/// full scale) at every sample. The inputs have one length; a sample of `whole` that is larger was turned
/// down. Empty for no samples. Any thread; allocates.
std::vector<GainPoint> limiterGains(const std::vector<float>& whole, const std::vector<float>& limited,
                                    double tolerance);

}  // namespace detent::playback
