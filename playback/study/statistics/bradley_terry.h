// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scores of things that were compared in pairs by preference (Bradley & Terry, Biometrika 1952).
// Deterministic; any thread.

#include <cstddef>
#include <vector>

#include "playback/study/statistics/binomial.h"

namespace detent::playback {

/// One choice by a person.
struct Preference {
  std::size_t person = 0;  ///< less than the number of people
  std::size_t winner = 0, loser = 0;
};

struct PreferenceScores {
  /// Log odds; the mean of all is 0. The odds that i is preferred to k are exp(score[i] - score[k]).
  std::vector<double> scores;
  std::vector<Interval> intervals;  ///< interval of each score
  /// the intervals treat persons, not trials, as independent: for six people and more
  bool personsCounted = false;
};

/// Maximum-likelihood scores, with half a choice in either direction added for every pair that was compared,
/// so that scores stay finite if one was always preferred. Intervals: for six people and more, by the
/// sandwich estimator over persons with Student's quantile; for fewer, trials count as independent, which
/// gives too narrow intervals. `things` >= 2; winner and loser differ. `confidence` in (0, 1).
PreferenceScores bradleyTerry(const std::vector<Preference>& preferences, std::size_t things,
                              double confidence = 0.95);

}  // namespace detent::playback
