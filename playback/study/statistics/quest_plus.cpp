// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/quest_plus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "model/check.h"

namespace detent::playback {

namespace {

constexpr std::size_t thresholdSteps = 81;
constexpr double beyondLargest = 1.5;
// A d' proportional to the difference corresponds to a slope of about 1.25; differences that are either felt
// or not have steeper slopes.
constexpr std::array slopes{1.0, 1.4, 2.0, 2.8, 4.0};
constexpr std::array lapses{0.0, 0.02, 0.05};
constexpr std::size_t shapes = slopes.size() * lapses.size();

double plogp(double p) { return p > 0 ? p * std::log(p) : 0; }

}  // namespace

double shareCorrect(double difference, double threshold, double slope, double lapse) {
  return 0.5 + (0.5 - lapse) * (1 - std::exp2(-std::pow(difference / threshold, slope)));
}

QuestPlus::QuestPlus(std::vector<double> levels) : levels_(std::move(levels)) {
  DETENT_CHECK(levels_.size() > 1 && levels_.front() > 0 && std::is_sorted(levels_.begin(), levels_.end()),
               "differences that rise");
  const double low = std::log(levels_.front()), high = std::log(beyondLargest * levels_.back());
  for (std::size_t i = 0; i < thresholdSteps; ++i)
    thresholds_.push_back(std::exp(low + (high - low) * static_cast<double>(i) / (thresholdSteps - 1)));
  belief_.assign(thresholdSteps * shapes, 1.0 / static_cast<double>(thresholdSteps * shapes));
  for (const double level : levels_) {
    std::vector<double>& correct = correct_.emplace_back();
    for (const double threshold : thresholds_)
      for (const double slope : slopes)
        for (const double lapse : lapses) correct.push_back(shareCorrect(level, threshold, slope, lapse));
  }
}

double QuestPlus::expectedEntropy(std::size_t level) const {
  const std::vector<double>& correct = correct_[level];
  double right = 0, rightTerms = 0, wrongTerms = 0;
  for (std::size_t i = 0; i < belief_.size(); ++i) {
    const double joint = belief_[i] * correct[i];
    right += joint;
    rightTerms += plogp(joint);
    wrongTerms += plogp(belief_[i] - joint);
  }
  return plogp(right) - rightTerms + plogp(1 - right) - wrongTerms;
}

std::size_t QuestPlus::nextLevel() const {
  std::size_t best = 0;
  double least = expectedEntropy(0);
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    const double entropy = expectedEntropy(level);
    if (entropy < least) {
      least = entropy;
      best = level;
    }
  }
  return best;
}

void QuestPlus::take(const LevelAnswer& answer) {
  DETENT_CHECK(answer.level < levels_.size(), "one of the levels");
  const std::vector<double>& correct = correct_[answer.level];
  double sum = 0;
  for (std::size_t i = 0; i < belief_.size(); ++i) {
    belief_[i] *= answer.correct ? correct[i] : 1 - correct[i];
    sum += belief_[i];
  }
  for (double& b : belief_) b /= sum;
}

double QuestPlus::thresholdAt(double cumulated, const std::vector<double>& byThreshold) const {
  double below = 0;
  // each threshold represents the interval around it
  const double half = std::log(thresholds_[1] / thresholds_[0]) / 2;
  for (std::size_t i = 0; i < thresholds_.size(); ++i) {
    if (below + byThreshold[i] >= cumulated && byThreshold[i] > 0)
      return thresholds_[i] * std::exp(half * (2 * (cumulated - below) / byThreshold[i] - 1));
    below += byThreshold[i];
  }
  return thresholds_.back() * std::exp(half);
}

ThresholdEstimate QuestPlus::estimate(double confidence) const {
  std::vector<double> byThreshold(thresholds_.size(), 0);
  for (std::size_t i = 0; i < belief_.size(); ++i) byThreshold[i / shapes] += belief_[i];
  const double tail = (1 - confidence) / 2;
  ThresholdEstimate estimate;
  estimate.threshold = thresholdAt(0.5, byThreshold);
  estimate.credible = {thresholdAt(tail, byThreshold), thresholdAt(1 - tail, byThreshold)};
  estimate.beyondLevels = byThreshold.front() >= tail || byThreshold.back() >= tail;
  return estimate;
}

}  // namespace detent::playback
