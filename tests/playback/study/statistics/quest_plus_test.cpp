// SPDX-License-Identifier: GPL-3.0-or-later
// Expected numbers: reference_preferences.py.
#include "playback/study/statistics/quest_plus.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "playback/study/statistics/shuffle.h"

using namespace detent::playback;

namespace {

std::vector<double> hundredthToDouble() {
  std::vector<double> levels;
  for (int i = 0; i <= 24; ++i) levels.push_back(0.01 * std::pow(10.0, i / 12.0));
  return levels;
}

struct Observer {
  double threshold, slope, lapse;
};

ThresholdEstimate estimated(const Observer& observer, std::size_t trials, StudyRandom& random) {
  const std::vector<double> levels = hundredthToDouble();
  QuestPlus quest(levels);
  for (std::size_t i = 0; i < trials; ++i) {
    const std::size_t level = quest.nextLevel();
    const double share = shareCorrect(levels[level], observer.threshold, observer.slope, observer.lapse);
    quest.take({level, drawShare(random) < share});
  }
  return quest.estimate();
}

}  // namespace

TEST_CASE("a threshold is noticed in 75 of 100, and an endless difference as often as nobody lapses") {
  CHECK(shareCorrect(0.1, 0.1, 3, 0) == Approx(0.75));
  CHECK(shareCorrect(0.1, 0.1, 1, 0.04) == Approx(0.73));
  CHECK(shareCorrect(100, 0.1, 2, 0.05) == Approx(0.95));
  CHECK(shareCorrect(1e-9, 0.1, 2, 0.05) == Approx(0.5));
}

TEST_CASE("QUEST+ asks and believes what the reference program asks and believes") {
  const std::vector<std::size_t> expected{15, 13, 12, 18, 17, 17, 16, 15, 14, 13,
                                          11, 15, 15, 14, 14, 14, 13, 13, 12, 11};
  const std::vector<double> levels = hundredthToDouble();
  QuestPlus quest(levels);
  std::vector<std::size_t> levelsRequested;
  for (int i = 0; i < 20; ++i) {
    const std::size_t level = quest.nextLevel();
    levelsRequested.push_back(level);
    quest.take({level, levels[level] > 0.12 || i % 3 == 0});
  }
  CHECK(levelsRequested == expected);
  const ThresholdEstimate e = quest.estimate();
  CHECK(e.credible.low == Approx(0.0381007743).epsilon(1e-8));
  CHECK(e.threshold == Approx(0.09459737).epsilon(1e-8));
  CHECK(e.credible.high == Approx(0.168386868).epsilon(1e-8));
  CHECK_FALSE(e.beyondLevels);
}

TEST_CASE("observers' thresholds lie within the credible interval in 95 of 100") {
  StudyRandom random(26);
  constexpr int observers = 400;
  int within = 0;
  double squares = 0;
  for (int i = 0; i < observers; ++i) {
    const Observer observer{0.01 * std::pow(150.0, drawShare(random)), std::pow(4.0, drawShare(random)),
                            0.05 * drawShare(random)};
    const ThresholdEstimate e = estimated(observer, 60, random);
    within += e.credible.low <= observer.threshold && observer.threshold <= e.credible.high ? 1 : 0;
    squares += std::pow(std::log(e.threshold / observer.threshold), 2);
  }
  CHECK(within >= 0.92 * observers);
  CHECK(within <= 0.98 * observers);
  CHECK(std::sqrt(squares / observers) < 0.45);
}

TEST_CASE("a participant who notices nothing, or everything, has an open interval") {
  QuestPlus deaf(hundredthToDouble()), keen(hundredthToDouble());
  for (int i = 0; i < 40; ++i) {
    deaf.take({deaf.nextLevel(), i % 2 == 0});
    keen.take({keen.nextLevel(), true});
  }
  CHECK(deaf.estimate().beyondLevels);
  CHECK(keen.estimate().beyondLevels);
  CHECK(keen.estimate().threshold < 0.02);
  CHECK(deaf.estimate().threshold > 0.5);
}
