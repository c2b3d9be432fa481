// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Power of a study: the share of simulated studies in which the reported test finds the difference.
// Deterministic; any thread.

#include <cstddef>
#include <functional>
#include <vector>

#include "playback/study/statistics/binomial.h"
#include "playback/study/statistics/shuffle.h"

namespace detent::playback {

/// The p of pairedDifference() for differences that are whole numbers, exact for any number of people; 1 for
/// nobody.
double signFlipP(const std::vector<int>& differences);

/// One person's difference between two conditions, in steps of any size.
using DrawDifference = std::function<int(StudyRandom&)>;

/// Share of studies with p <= `level`. The standard error is at most 0.5 / sqrt(studies): 0.9 % of 3,000.
double signFlipPower(std::size_t people, const DrawDifference& draw, double level = 0.05,
                     std::size_t studies = 3000);

/// Error rates of people in two conditions of `trials` each: the median person's rate is `rate` in one and
/// `rate` + `difference` in the other.
struct ErrorRates {
  std::size_t trials = 10;
  double rate = 0.1;           ///< (0, 1)
  double difference = 0.1;     ///< rate + difference in (0, 1)
  double spread = 0.5;         ///< standard deviation over people of the log odds of an error
  double effectSpread = 0.25;  ///< standard deviation over people of the difference of the log odds
};
/// Errors in the second condition minus those in the first, for one person drawn at random.
int drawErrorDifference(const ErrorRates& rates, StudyRandom& random);

/// A normal number of mean 0 and standard deviation 1 (Box & Muller 1958).
double drawNormal(StudyRandom& random);

}  // namespace detent::playback
