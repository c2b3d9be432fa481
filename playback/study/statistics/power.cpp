// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/power.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace detent::playback {

namespace {

constexpr const char* seedText = "power of a study";

double logOdds(double share) { return std::log(share / (1 - share)); }
double shareOfOdds(double odds) { return 1 / (1 + std::exp(-odds)); }

int drawErrors(std::size_t trials, double rate, StudyRandom& random) {
  int errors = 0;
  for (std::size_t i = 0; i < trials; ++i) errors += drawShare(random) < rate ? 1 : 0;
  return errors;
}

}  // namespace

double signFlipP(const std::vector<int>& differences) {
  int total = 0, reach = 0;
  for (const int d : differences) {
    total += d;
    reach += std::abs(d);
  }
  // Share of sign patterns with each sum, built up person by person.
  std::vector<double> shares(2 * static_cast<std::size_t>(reach) + 1, 0.0);
  shares[static_cast<std::size_t>(reach)] = 1;
  for (const int d : differences) {
    const auto step = static_cast<std::size_t>(std::abs(d));
    std::vector<double> next(shares.size(), 0.0);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (shares[i] == 0) continue;
      next[i + step] += shares[i] / 2;
      next[i - step] += shares[i] / 2;
    }
    shares = std::move(next);
  }
  double asFar = 0;
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (std::abs(static_cast<int>(i) - reach) >= std::abs(total)) asFar += shares[i];
  return asFar;
}

double signFlipPower(std::size_t people, const DrawDifference& draw, double level, std::size_t studies) {
  constexpr double roundOff = 1e-12;
  StudyRandom random = randomSeededBy(seedText);
  std::size_t found = 0;
  std::vector<int> differences(people);
  for (std::size_t study = 0; study < studies; ++study) {
    for (int& difference : differences) difference = draw(random);
    if (signFlipP(differences) <= level + roundOff) ++found;
  }
  return static_cast<double>(found) / static_cast<double>(studies);
}

int drawErrorDifference(const ErrorRates& rates, StudyRandom& random) {
  const double person = rates.spread * drawNormal(random);
  const double effect =
      logOdds(rates.rate + rates.difference) - logOdds(rates.rate) + rates.effectSpread * drawNormal(random);
  const double first = logOdds(rates.rate) + person;
  return drawErrors(rates.trials, shareOfOdds(first + effect), random) -
         drawErrors(rates.trials, shareOfOdds(first), random);
}

double drawNormal(StudyRandom& random) {
  const double radius = std::sqrt(-2 * std::log(1 - drawShare(random)));
  return radius * std::cos(2 * std::numbers::pi * drawShare(random));
}

}  // namespace detent::playback
