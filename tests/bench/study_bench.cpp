// SPDX-License-Identifier: GPL-3.0-or-later
// detent_study_bench: how often the tests that a study's report prints cry wolf, and how often they find what
// is there. Its table stands in docs/measurements/coverage.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "playback/measurement/normal.h"
#include "playback/study/statistics/binomial.h"
#include "playback/study/statistics/bradley_terry.h"
#include "playback/study/statistics/paired_difference.h"
#include "playback/study/statistics/quest_plus.h"
#include "playback/study/statistics/rank_correlation.h"
#include "playback/study/statistics/resampling.h"
#include "playback/study/statistics/shuffle.h"

namespace {

using namespace detent::playback;

constexpr double level = 0.05;

double normal(StudyRandom& random) { return normalQuantile(std::max(drawShare(random), 1e-15)); }

Count answers(double rate, std::size_t trials, StudyRandom& random) {
  Count count{0, trials};
  for (std::size_t i = 0; i < trials; ++i) count.errors += drawShare(random) < rate ? 1 : 0;
  return count;
}

/// People differ: each has an error rate of their own.
double personsRate(double mean, StudyRandom& random) {
  return normalCdf(normalQuantile(mean) + 0.4 * normal(random));
}

void row(const char* test, std::size_t studies, StudyRandom& random,
         const std::function<double(StudyRandom&)>& p) {
  Count alarms{0, studies};
  for (std::size_t i = 0; i < studies; ++i) alarms.errors += p(random) <= level ? 1 : 0;
  const Interval interval = wilson(alarms);
  std::printf("| %s | %zu | %.2f (%.2f–%.2f) |\n", test, studies, 100 * rateOf(alarms), 100 * interval.low,
              100 * interval.high);
  std::fflush(stdout);
}

double pairedP(std::size_t people, double effect, StudyRandom& random) {
  std::vector<double> differences(people);
  for (double& d : differences) d = normal(random) + effect;
  return pairedDifference(differences).p;
}

double pairedCountsP(std::size_t people, double rate, double otherRate, StudyRandom& random) {
  std::vector<double> differences(people);
  for (double& d : differences) {
    const double person = normal(random);
    const auto of = [&](double mean) { return normalCdf(normalQuantile(mean) + 0.4 * person); };
    d = rateOf(answers(of(rate), 150, random)) - rateOf(answers(of(otherRate), 150, random));
  }
  return pairedDifference(differences).p;
}

double groupsP(std::size_t people, double rate, StudyRandom& random) {
  std::vector<Count> first, second;
  for (std::size_t i = 0; i < people; ++i) {
    first.push_back(answers(personsRate(rate, random), 150, random));
    second.push_back(answers(personsRate(rate, random), 150, random));
  }
  return groupDifferenceP(first, second, {.resamples = 999});
}

double spearmanNullP(StudyRandom& random) {
  std::vector<double> x(15), y(15);
  for (double& v : x) v = normal(random);
  for (double& v : y) v = normal(random);
  return spearmanP(x, y);
}

/// Fifteen pairs of ten guessed trials each; whether any is believed after Holm.
double smallestAdjustedP(StudyRandom& random) {
  std::vector<double> p;
  for (int pair = 0; pair < 15; ++pair) p.push_back(atMost(answers(0.5, 10, random), 0.5));
  const std::vector<double> adjusted = holm(p);
  return *std::min_element(adjusted.begin(), adjusted.end());
}

// ---- thresholds

struct Observer {
  double threshold, slope, lapse;
};

std::vector<double> studyLevels() {
  std::vector<double> levels;
  for (int i = 0; i <= 24; ++i) levels.push_back(0.01 * std::pow(10.0, i / 12.0));
  return levels;
}

ThresholdEstimate estimated(const Observer& o, std::size_t trials, StudyRandom& random) {
  const std::vector<double> levels = studyLevels();
  QuestPlus quest(levels);
  for (std::size_t i = 0; i < trials; ++i) {
    const std::size_t at = quest.nextLevel();
    quest.take({at, drawShare(random) < shareCorrect(levels[at], o.threshold, o.slope, o.lapse)});
  }
  return quest.estimate();
}

/// Share of thresholds within the interval, and error of the estimate in the middle case.
void thresholdRow(const char* observers, std::size_t trials, std::size_t count, StudyRandom& random,
                  const std::function<Observer(StudyRandom&)>& drawn) {
  Count within{0, count};
  std::vector<double> off, width;
  for (std::size_t i = 0; i < count; ++i) {
    const Observer o = drawn(random);
    const ThresholdEstimate e = estimated(o, trials, random);
    within.errors += e.credible.low <= o.threshold && o.threshold <= e.credible.high ? 1 : 0;
    off.push_back(std::exp(std::fabs(std::log(e.threshold / o.threshold))) - 1);
    width.push_back(std::sqrt(e.credible.high / e.credible.low) - 1);
  }
  const auto middle = [](std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return 100 * values[values.size() / 2];
  };
  const Interval interval = wilson(within);
  std::printf("| %s | %zu | %zu | %.1f (%.1f–%.1f) | %.0f | %.0f |\n", observers, trials, count,
              100 * rateOf(within), 100 * interval.low, 100 * interval.high, middle(off), middle(width));
  std::fflush(stdout);
}

void thresholds(std::size_t count, StudyRandom& random) {
  std::printf(
      "\n| observers | trials | N | within 95 %% | off by, %% | interval, +- %% "
      "|\n|---|---|---|---|---|---|\n");
  const auto any = [](StudyRandom& r) {
    return Observer{0.01 * std::pow(150.0, drawShare(r)), std::pow(4.0, drawShare(r)), 0.05 * drawShare(r)};
  };
  for (const std::size_t trials : {20U, 40U, 60U, 120U}) thresholdRow("any", trials, count, random, any);
  for (const double slope : {1.25, 2.0, 3.5})
    for (const double threshold : {0.05, 0.1, 0.3}) {
      char name[64];
      std::snprintf(name, sizeof name, "threshold %.0f %%, slope %.3g, lapses 2 %%", 100 * threshold, slope);
      thresholdRow(name, 60, count / 2, random, [=](StudyRandom&) {
        return Observer{threshold, slope, 0.02};
      });
    }
}

// ---- preferences

/// Six buttons of which each person prefers according to a taste around the common one.
std::vector<Preference> preferencesOf(std::size_t people, double tasteSd, const std::vector<double>& common,
                                      StudyRandom& random) {
  std::vector<Preference> choices;
  for (std::size_t person = 0; person < people; ++person) {
    std::vector<double> taste = common;
    for (double& t : taste) t += tasteSd * normal(random);
    for (int round = 0; round < 4; ++round)
      for (std::size_t k = 1; k < taste.size(); ++k)
        for (std::size_t i = 0; i < k; ++i) {
          const bool first = drawShare(random) < 1 / (1 + std::exp(taste[k] - taste[i]));
          choices.push_back({person, first ? i : k, first ? k : i});
        }
  }
  return choices;
}

void preferenceRow(std::size_t people, double tasteSd, std::size_t count, StudyRandom& random) {
  const std::vector<double> alike(6, 0);
  Count within{0, count};
  for (std::size_t i = 0; i < count; ++i) {
    const PreferenceScores scores = bradleyTerry(preferencesOf(people, tasteSd, alike, random), 6);
    within.errors += scores.intervals[0].low <= 0 && scores.intervals[0].high >= 0 ? 1 : 0;
  }
  const Interval interval = wilson(within);
  std::printf("| %zu people, tastes differ by %.1f | %zu | %.1f (%.1f–%.1f) |\n", people, tasteSd, count,
              100 * rateOf(within), 100 * interval.low, 100 * interval.high);
  std::fflush(stdout);
}

double preferenceP(std::size_t people, double tasteSd, StudyRandom& random) {
  const std::vector<Preference> choices = preferencesOf(people, tasteSd, {0, 0}, random);
  std::vector<double> shares(people, 0);
  for (const Preference& c : choices) shares[c.person] += c.winner == 0 ? 0.125 : -0.125;
  return pairedDifference(shares).p;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t studies = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 10000;
  StudyRandom random(26);
  std::printf("| test, nothing there | studies | p <= 0.05, per cent |\n|---|---|---|\n");
  for (const std::size_t people : {6U, 8U, 9U, 12U, 18U}) {
    const std::string name = "same people in both, " + std::to_string(people) + " people";
    row(name.c_str(), studies, random, [=](StudyRandom& r) { return pairedP(people, 0, r); });
  }
  row("same people in both, 9 people, 150 trials each, 10 % errors", studies, random,
      [](StudyRandom& r) { return pairedCountsP(9, 0.1, 0.1, r); });
  row("other people in each, 9 and 9, 10 % errors", studies, random,
      [](StudyRandom& r) { return groupsP(9, 0.1, r); });
  row("Spearman of 15 pairs", studies, random, spearmanNullP);
  row("any of 15 guessed pairs after Holm", studies, random, smallestAdjustedP);
  row("two buttons preferred by 9 people, 4 choices each, tastes differ by 0", studies, random,
      [](StudyRandom& r) { return preferenceP(9, 0, r); });
  row("two buttons preferred by 9 people, 4 choices each, tastes differ by 1", studies, random,
      [](StudyRandom& r) { return preferenceP(9, 1, r); });
  std::printf("\n| test, something there | studies | found, per cent |\n|---|---|---|\n");
  row("same people in both, 9 people, one standard deviation", studies, random,
      [](StudyRandom& r) { return pairedP(9, 1, r); });
  row("same people in both, 9 people, 6 against 10 % errors of 150", studies, random,
      [](StudyRandom& r) { return pairedCountsP(9, 0.1, 0.06, r); });
  thresholds(studies / 10, random);
  std::printf("\n| Bradley-Terry scores of six buttons | N | within 95 %% |\n|---|---|---|\n");
  for (const std::size_t people : {6U, 9U, 18U})
    for (const double tasteSd : {0.0, 0.7}) preferenceRow(people, tasteSd, studies / 10, random);
}
