// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Smallest difference that a person notices, from few questions: after each answer the difference follows
// that promises the most information (QUEST+: Watson, Journal of Vision 2017). Two choices of which one has
// more. Deterministic; any thread.

#include <cstddef>
#include <vector>

#include "playback/study/statistics/binomial.h"

namespace detent::playback {

/// One question of two choices: the difference (level), and true if it was noticed.
struct LevelAnswer {
  std::size_t level = 0;  ///< index into the levels
  bool correct = false;
};

/// Estimate of a person's threshold: the difference that is noticed in 75 of 100 trials, lapses aside.
struct ThresholdEstimate {
  double threshold = 0;  ///< median, in the levels' unit
  Interval credible;     ///< equal tails, in the levels' unit
  bool beyondLevels =
      false;  ///< the credible interval reaches an end of what was thought possible: it is open there
};

/// The share of right answers to a difference: 1/2 + (1/2 - lapse) (1 - 2^-(difference/threshold)^slope)
/// (Weibull's form).
double shareToldApart(double difference, double threshold, double slope, double lapse);

/// QUEST+'s belief after some answers. The prior is even over all thresholds from the smallest level to half
/// as much again as the largest on a log scale, and over slopes of 1, 1.4, 2, 2.8, 4 and lapses of 0, 2, 5 %.
class QuestPlus {
 public:
  /// `levels`: differences, > 0, rising, at least two.
  explicit QuestPlus(std::vector<double> levels);

  /// The level whose answer leaves the least entropy on average.
  std::size_t nextLevel() const;
  void take(const LevelAnswer& answer);
  /// `confidence` in (0, 1).
  ThresholdEstimate estimate(double confidence = 0.95) const;

 private:
  double expectedEntropy(std::size_t level) const;
  double thresholdAt(double cumulated, const std::vector<double>& byThreshold) const;

  std::vector<double> levels_;
  std::vector<double> thresholds_;            ///< rising, evenly on a log scale
  std::vector<double> belief_;                ///< of every threshold, slope and lapse; sums to 1
  std::vector<std::vector<double>> correct_;  ///< by level: share of right answers under each
};

}  // namespace detent::playback
