// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Converts samples to another rate.

#include <vector>

namespace detent::playback {

/// Share of the lower rate up to which frequencies are kept within 1e-3.
inline constexpr double keptBand = 0.45;

/// Band-limited (windowed sinc with 32 zero crossings), without delay. Equal rates return the samples
/// unchanged. Rates > 0, with a ratio of at most 24.
std::vector<float> resampled(const std::vector<float>& samples, double from_Hz, double to_Hz);

}  // namespace detent::playback
