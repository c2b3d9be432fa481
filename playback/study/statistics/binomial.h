// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Counts of errors: exact tails, intervals of a rate, several tests at once. Any thread.

#include <cstddef>
#include <vector>

namespace detent::playback {

struct Count {
  std::size_t errors = 0;
  std::size_t trials = 0;
  friend bool operator==(const Count&, const Count&) = default;
};

/// Sum of errors and of trials of all counts; zero for an empty list.
Count sumOf(const std::vector<Count>& counts);

/// A rate with its interval, all in [0, 1].
struct Interval {
  double low = 0, high = 1;
};

/// errors / trials; 0 without trials.
double rateOf(const Count& count);

/// P(at most `errors` of `trials` are errors) if each is one with probability `rate`. "At most one error in
/// ten" by guessing: atMost({1, 10}, 0.5) = 11/1024 = 0.0107.
double atMost(const Count& count, double rate);

/// Wilson's score interval (Wilson, JASA 1927). `confidence` in (0, 1). Without trials: [0, 1].
Interval wilson(const Count& count, double confidence = 0.95);

/// The exact interval (Clopper & Pearson, Biometrika 1934).
Interval clopperPearson(const Count& count, double confidence = 0.95);

/// P values adjusted for all tests together (Holm, Scand. J. Statist. 1979), in the order given.
std::vector<double> holm(const std::vector<double>& p);

}  // namespace detent::playback
