// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Compares the same people under two conditions. Each person is their own control: without an effect only the
// sign of a difference is random. Deterministic; any thread.

#include <optional>
#include <vector>

#include "playback/study/statistics/binomial.h"

namespace detent::playback {

/// Mean of the differences with its p and interval.
struct PairedDifference {
  double mean = 0;
  /// Two-sided, by flipping the signs of whole persons (Fisher 1935): exact up to 20 people, with 100,000
  /// random flips above. 1 for nobody.
  double p = 1;
  /// Interval of the mean: the values that the same test does not reject, from the means of all subsets
  /// (Hartigan, JASA 1969). None for so few people that nothing can be excluded: fewer than six for 95 %.
  std::optional<Interval> interval;
};

/// `differences`: one finite number per person, in any unit. `confidence` in (0, 1).
PairedDifference pairedDifference(const std::vector<double>& differences, double confidence = 0.95);

}  // namespace detent::playback
