// SPDX-License-Identifier: GPL-3.0-or-later
// Expected numbers: reference_preferences.py.
#include "playback/study/statistics/bradley_terry.h"

#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "playback/study/statistics/shuffle.h"

using namespace detent::playback;

namespace {

/// As in the reference: five choices each, some turned.
std::vector<Preference> choicesOf(std::size_t people) {
  constexpr std::size_t pairs[][2] = {{0, 1}, {0, 1}, {0, 2}, {1, 2}, {2, 1}};
  std::vector<Preference> choices;
  for (std::size_t i = 0; i < 5 * people; ++i) {
    const std::size_t person = i / 5;
    const auto& [winner, loser] = pairs[i % 5];
    const bool turned = (person * 7 + i * 3) % 5 == 0;
    choices.push_back({person, turned ? loser : winner, turned ? winner : loser});
  }
  return choices;
}

double halfWidth(const PreferenceScores& s, std::size_t i) {
  return (s.intervals[i].high - s.intervals[i].low) / 2;
}

}  // namespace

TEST_CASE("scores and intervals are those of the reference program") {
  const PreferenceScores eight = bradleyTerry(choicesOf(8), 3);
  CHECK(eight.personsCounted);
  const double scores[] = {0.6642343188, -0.3392280036, -0.3250063152};
  const double byPersons[] = {0.4155056658, 0.4353736627, 0.5106577918};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(eight.scores[i] == Approx(scores[i]).epsilon(1e-6));
    CHECK(halfWidth(eight, i) == Approx(byPersons[i]).epsilon(1e-6));
  }
  const PreferenceScores five = bradleyTerry(choicesOf(5), 3);
  CHECK_FALSE(five.personsCounted);
  const double fewer[] = {0.7832887983, -0.4044329375, -0.3788558608};
  const double byTrials[] = {0.7539432585, 0.6057928779, 0.6883518422};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(five.scores[i] == Approx(fewer[i]).epsilon(1e-6));
    CHECK(halfWidth(five, i) == Approx(byTrials[i]).epsilon(1e-6));
  }
}

TEST_CASE("what always wins has a finite score, what nobody compared has none against the rest") {
  std::vector<Preference> choices;
  for (std::size_t person = 0; person < 8; ++person) choices.push_back({person, 0, 1});
  const PreferenceScores scores = bradleyTerry(choices, 3);
  CHECK(scores.scores[0] - scores.scores[1] == Approx(std::log(8.5 / 0.5)));
  CHECK(std::isfinite(scores.scores[2]));
  CHECK(std::accumulate(scores.scores.begin(), scores.scores.end(), 0.0) == Approx(0).margin(1e-9));
}

TEST_CASE("twelve people's intervals hold the true scores in 95 of 100 cases, though persons differ") {
  const std::vector<double> truth{0.8, 0, -0.8};
  StudyRandom random(1952);
  constexpr int studies = 400;
  constexpr std::size_t people = 12, rounds = 4;
  int within = 0;
  for (int study = 0; study < studies; ++study) {
    std::vector<Preference> choices;
    for (std::size_t person = 0; person < people; ++person)
      for (std::size_t round = 0; round < rounds; ++round)
        for (std::size_t k = 1; k < 3; ++k)
          for (std::size_t i = 0; i < k; ++i) {
            const bool first = drawShare(random) < 1 / (1 + std::exp(truth[k] - truth[i]));
            choices.push_back({person, first ? i : k, first ? k : i});
          }
    const PreferenceScores found = bradleyTerry(choices, 3);
    within += found.intervals[0].low <= truth[0] && truth[0] <= found.intervals[0].high ? 1 : 0;
  }
  CHECK(within >= 0.92 * studies);
  CHECK(within <= 0.98 * studies);
}
