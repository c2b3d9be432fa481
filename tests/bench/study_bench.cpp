// SPDX-License-Identifier: GPL-3.0-or-later
// detent_study_bench: how often the tests that a study's report prints cry wolf, and how often they find what is there. Its table stands in
// docs/coverage.md.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "playback/measurement/normal.h"
#include "playback/study/statistics/binomial.h"
#include "playback/study/statistics/paired_difference.h"
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
  std::printf("| %s | %zu | %.2f (%.2f to %.2f) |\n", test, studies, 100 * rateOf(alarms), 100 * interval.low,
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

}  // namespace

int main(int argc, char** argv) {
  const std::size_t studies = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 10000;
  StudyRandom random(26);
  std::printf("| test, nothing there | studies | p <= 0.05, per cent |\n|---|---|---|\n");
  for (const std::size_t people : {6U, 8U, 9U, 12U, 18U}) {
    const std::string name = "same people in both, " + std::to_string(people) + " people";
    row(name.c_str(), people > 12 ? studies / 20 : studies, random,
        [=](StudyRandom& r) { return pairedP(people, 0, r); });
  }
  row("same people in both, 9 people, 150 trials each, 10 % errors", studies, random,
      [](StudyRandom& r) { return pairedCountsP(9, 0.1, 0.1, r); });
  row("other people in each, 9 and 9, 10 % errors", studies, random,
      [](StudyRandom& r) { return groupsP(9, 0.1, r); });
  row("Spearman of 15 pairs", studies / 10, random, spearmanNullP);
  row("any of 15 guessed pairs after Holm", studies, random, smallestAdjustedP);
  std::printf("\n| test, something there | studies | found, per cent |\n|---|---|---|\n");
  row("same people in both, 9 people, one standard deviation", studies, random,
      [](StudyRandom& r) { return pairedP(9, 1, r); });
  row("same people in both, 9 people, 6 against 10 % errors of 150", studies, random,
      [](StudyRandom& r) { return pairedCountsP(9, 0.1, 0.06, r); });
}
