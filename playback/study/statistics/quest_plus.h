// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds the smallest difference that a person notices with few questions: after each answer the difference
// with the most expected information follows (QUEST+: Watson, Journal of Vision 2017). Each question
// has two choices, of which one has more. Deterministic; any thread.

#include <cstddef>
#include <vector>

#include "playback/study/statistics/binomial.h"

namespace detent::playback {

/// Answer to one question: the difference (level), and true if it was noticed.
struct LevelAnswer {
  std::size_t level = 0;  ///< index into the levels
  bool correct = false;
};

/// Estimate of a person's threshold: the difference that is noticed in 75 of 100 trials, not counting lapses.
struct ThresholdEstimate {
  double threshold = 0;  ///< median, in the levels' unit
  Interval credible;     ///< equal tails, in the levels' unit
  /// The credible interval reaches an end of the prior's range, so that end of it is open.
  bool beyondLevels = false;
};

/// Expected share of correct answers, 0.5 to 1 - lapse: 1/2 + (1/2 - lapse) (1 -
/// 2^-(difference/threshold)^slope) (Weibull's form). `difference` and `threshold` (> 0) are in the levels'
/// unit; `lapse` is the share of answers that are wrong whatever the difference.
double shareCorrect(double difference, double threshold, double slope, double lapse);

/// QUEST+'s posterior after some answers. The prior is uniform over 81 thresholds from the smallest level to
/// 1.5 times the largest in equal steps of a log scale, each of which represents the step around it, over
/// slopes of 1, 1.4, 2, 2.8, 4, and over lapses of 0, 2, 5 %.
class QuestPlus {
 public:
  /// `levels`: differences, > 0, increasing, at least two.
  explicit QuestPlus(std::vector<double> levels);

  /// The level whose answer leaves the least expected entropy.
  std::size_t nextLevel() const;
  void take(const LevelAnswer& answer);
  /// `confidence` in (0, 1).
  ThresholdEstimate estimate(double confidence = 0.95) const;

 private:
  double expectedEntropy(std::size_t level) const;
  double thresholdAt(double cumulated, const std::vector<double>& byThreshold) const;

  std::vector<double> levels_;
  std::vector<double> thresholds_;            ///< increasing, evenly spaced on a log scale
  std::vector<double> belief_;                ///< probability of every threshold, slope and lapse; sums to 1
  std::vector<std::vector<double>> correct_;  ///< by level: share of correct answers for each of these
};

}  // namespace detent::playback
