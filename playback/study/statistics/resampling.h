// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Intervals for few people. Answers of one person are not independent, so persons are resampled, not trials.
// Deterministic for a seed; any thread.

#include <cstdint>
#include <optional>
#include <vector>

#include "playback/study/statistics/binomial.h"

namespace detent::playback {

struct ResamplingSettings {
  std::size_t resamples = 4000;  ///< >= 100
  std::uint64_t seed = 20131008;
  double confidence = 0.95;  ///< (0, 1)
};

/// Bias-corrected and accelerated bootstrap interval (Efron, JASA 1987), widened for few participants, of the
/// rate of all errors over all trials, resampling participants. Nothing for fewer than six participants,
/// whose resamples cover too little (docs/measurements/coverage.md), or if all are equal, so that resamples
/// would not differ.
std::optional<Interval> participantBootstrap(const std::vector<Count>& participants,
                                             const ResamplingSettings& settings = {});

/// Two-sided p that the mean error rates of two groups of participants differ, by permuting group membership.
/// 1 if a group is empty.
double groupDifferenceP(const std::vector<Count>& first, const std::vector<Count>& second,
                        const ResamplingSettings& settings = {});

}  // namespace detent::playback
