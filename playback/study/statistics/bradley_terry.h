// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scores of things that were preferred to each other, two at a time (Bradley & Terry, Biometrika 1952).
// Deterministic; any thread.

#include <cstddef>
#include <vector>

#include "playback/study/statistics/binomial.h"

namespace detent::playback {

/// One choice of a person.
struct Preference {
  std::size_t person = 0;  ///< below the number of people
  std::size_t winner = 0, loser = 0;
};

struct PreferenceScores {
  /// Log odds; the mean of all is 0. The odds that i is preferred to k are exp(score[i] - score[k]).
  std::vector<double> scores;
  std::vector<Interval> intervals;  ///< of each score
  bool personsCounted = false;  ///< intervals take persons, not trials, as independent: from six people on
};

/// Scores of largest likelihood, with half a choice either way added for every two that were compared: where
/// one was always preferred they stay finite. Intervals: from six people on the sandwich of what each person
/// adds, with Student's quantile; below, trials as independent, which is too narrow. `things` >= 2; winner
/// and loser differ. `confidence` in (0, 1).
PreferenceScores bradleyTerry(const std::vector<Preference>& preferences, std::size_t things,
                              double confidence = 0.95);

}  // namespace detent::playback
