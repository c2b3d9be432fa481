// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Samples at another rate.

#include <vector>

namespace detent::playback {

/// Share of the lower rate: frequencies below it stay within 1e-3.
inline constexpr double keptBand = 0.45;

/// Band-limited (a windowed sinc of 32 zero crossings), without a delay. The same samples for the same rate.
/// Rates > 0, at most a factor of 24 apart.
std::vector<float> resampled(const std::vector<float>& samples, double from_Hz, double to_Hz);

}  // namespace detent::playback
