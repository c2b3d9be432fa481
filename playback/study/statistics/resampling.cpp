// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/resampling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "playback/measurement/normal.h"
#include "playback/study/statistics/shuffle.h"

namespace detent::playback {

namespace {

// Resamples cannot go beyond the data of few people: intervals of five cover the truth in 86 to 92 of 100
// cases, those of six in 90 and more.
constexpr std::size_t fewestParticipants = 6;

double rateWithout(const std::vector<Count>& counts, const Count& sum, std::size_t leftOut) {
  return rateOf({sum.errors - counts[leftOut].errors, sum.trials - counts[leftOut].trials});
}

/// Efron's acceleration, from leaving each participant out.
double accelerationOf(const std::vector<Count>& counts) {
  const Count sum = sumOf(counts);
  std::vector<double> rates;
  for (std::size_t i = 0; i < counts.size(); ++i) rates.push_back(rateWithout(counts, sum, i));
  const double mean = std::accumulate(rates.begin(), rates.end(), 0.0) / static_cast<double>(rates.size());
  double squares = 0, cubes = 0;
  for (const double r : rates) {
    squares += (mean - r) * (mean - r);
    cubes += (mean - r) * (mean - r) * (mean - r);
  }
  return squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
}

double quantileOf(const std::vector<double>& sorted, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (sorted[above] - sorted[below]) * (place - static_cast<double>(below));
}

std::vector<double> resampledRates(const std::vector<Count>& counts, const ResamplingSettings& settings) {
  StudyRandom random(settings.seed);
  std::vector<double> rates(settings.resamples);
  for (double& rate : rates) {
    Count sum;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const Count& drawn = counts[drawBelow(random, counts.size())];
      sum.errors += drawn.errors;
      sum.trials += drawn.trials;
    }
    rate = rateOf(sum);
  }
  std::sort(rates.begin(), rates.end());
  return rates;
}

double meanRate(const std::vector<double>& rates, std::size_t from, std::size_t to) {
  return std::accumulate(rates.begin() + static_cast<std::ptrdiff_t>(from),
                         rates.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
         static_cast<double>(to - from);
}

}  // namespace

std::optional<Interval> participantBootstrap(const std::vector<Count>& participants,
                                             const ResamplingSettings& settings) {
  if (participants.size() < fewestParticipants) return {};
  const std::vector<double> rates = resampledRates(participants, settings);
  if (rates.front() == rates.back()) return {};
  const double observed = rateOf(sumOf(participants));
  // Ties count half, because rates of few participants have few values.
  const auto below =
      static_cast<double>(std::lower_bound(rates.begin(), rates.end(), observed) - rates.begin());
  const auto upTo =
      static_cast<double>(std::upper_bound(rates.begin(), rates.end(), observed) - rates.begin());
  const double half = 0.5 / static_cast<double>(rates.size());
  const double bias =
      normalQuantile(std::clamp((below + upTo) / (2 * static_cast<double>(rates.size())), half, 1 - half));
  const double acceleration = accelerationOf(participants);
  // Resamples of n people have only (n - 1) / n of the variance, which itself is known from only n people:
  // the tails are widened to Student's (Hesterberg, American Statistician 2015).
  const auto people = static_cast<double>(participants.size());
  const auto corrected = [&](double share) {
    const double z =
        bias + std::sqrt(people / (people - 1)) * studentQuantile(share, participants.size() - 1);
    const double stretch = 1 - acceleration * z;
    return stretch > 0 ? normalCdf(bias + z / stretch) : z > 0 ? 1 : 0;
  };
  const double tail = (1 - settings.confidence) / 2;
  return Interval{quantileOf(rates, corrected(tail)), quantileOf(rates, corrected(1 - tail))};
}

double groupDifferenceP(const std::vector<Count>& first, const std::vector<Count>& second,
                        const ResamplingSettings& settings) {
  if (first.empty() || second.empty()) return 1;
  std::vector<double> rates;
  for (const Count& c : first) rates.push_back(rateOf(c));
  for (const Count& c : second) rates.push_back(rateOf(c));
  const auto difference = [&] {
    return std::fabs(meanRate(rates, 0, first.size()) - meanRate(rates, first.size(), rates.size()));
  };
  constexpr double roundOff = 1e-12;
  const double observed = difference() - roundOff;
  StudyRandom random(settings.seed);
  std::size_t asFar = 1;  // the observed order is one of them
  for (std::size_t i = 0; i < settings.resamples; ++i) {
    shuffle(rates, random);
    if (difference() >= observed) ++asFar;
  }
  return static_cast<double>(asFar) / static_cast<double>(settings.resamples + 1);
}

}  // namespace detent::playback
