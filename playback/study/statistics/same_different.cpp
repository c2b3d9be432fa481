// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/same_different.h"

#include <algorithm>
#include <cmath>

#include "playback/measurement/normal.h"
#include "playback/measurement/root.h"

namespace detent::playback {

namespace {

constexpr double farthest = 40, root2 = 1.4142135623730951;

/// Probability of "different" for stimuli at this distance, with a criterion.
double calledDifferent(double dPrime, double criterion) {
  return normalCdf((dPrime - criterion) / root2) + normalCdf((-dPrime - criterion) / root2);
}

double plusLog(double total, std::size_t times, double share) {
  return times == 0 ? total : total + static_cast<double>(times) * std::log(share);
}

double likelihood(const SameDifferentCount& c, double hitShare, double alarmShare) {
  double total = plusLog(0, c.hits, hitShare);
  total = plusLog(total, c.different - c.hits, 1 - hitShare);
  total = plusLog(total, c.falseAlarms, alarmShare);
  return plusLog(total, c.same - c.falseAlarms, 1 - alarmShare);
}

/// Log likelihood of a distance, with the criterion that fits it best (golden section search).
double profile(const SameDifferentCount& c, double dPrime) {
  constexpr double golden = 0.6180339887498949, narrow = 1e-9;
  const auto at = [&](double k) { return likelihood(c, calledDifferent(dPrime, k), calledDifferent(0, k)); };
  double low = 1e-9, high = farthest;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double atLeft = at(left), atRight = at(right);
  while (high - low > narrow) {
    if (atLeft >= atRight || std::isnan(atRight)) {
      high = right;
      right = left;
      atRight = atLeft;
      atLeft = at(left = high - golden * (high - low));
    } else {
      low = left;
      left = right;
      atLeft = atRight;
      atRight = at(right = low + golden * (high - low));
    }
  }
  return at(low + (high - low) / 2);
}

double shareOf(std::size_t count, std::size_t trials) {
  return static_cast<double>(count) / static_cast<double>(trials);
}

/// The share; moved by half an answer if it is 0 or 1.
double within(std::size_t count, std::size_t trials, bool& moved) {
  moved |= count == 0 || count == trials;
  const double half = 0.5 / static_cast<double>(trials);
  return std::clamp(shareOf(count, trials), half, 1 - half);
}

/// Probabilities of each number of hits for one person who said "different" this often (hypergeometric).
std::vector<double> hitChances(const SameDifferentCount& c) {
  const auto choose = [](std::size_t n, std::size_t k) {
    const auto gamma = [](std::size_t i) { return std::lgamma(static_cast<double>(i) + 1); };
    return gamma(n) - gamma(k) - gamma(n - k);
  };
  const std::size_t said = c.hits + c.falseAlarms;
  std::vector<double> chances(c.different + 1, 0.0);
  for (std::size_t hits = said > c.same ? said - c.same : 0; hits <= std::min(said, c.different); ++hits)
    chances[hits] = std::exp(choose(c.different, hits) + choose(c.same, said - hits) -
                             choose(c.different + c.same, said));
  return chances;
}

}  // namespace

SameDifferentCount sumOf(const std::vector<SameDifferentCount>& counts) {
  SameDifferentCount sum;
  for (const SameDifferentCount& c : counts) {
    sum.different += c.different;
    sum.hits += c.hits;
    sum.same += c.same;
    sum.falseAlarms += c.falseAlarms;
  }
  return sum;
}

SameDifferentDPrime dPrimeOf(const SameDifferentCount& c) {
  // half of the 95 % quantile of chi-squared with one degree of freedom
  constexpr double drop = 1.920729410347062;
  SameDifferentDPrime found;
  const double hits = within(c.hits, c.different, found.moved);
  const double alarms = within(c.falseAlarms, c.same, found.moved);
  const double criterion = -root2 * normalQuantile(alarms / 2);
  const auto shareAt = [&](double d) { return calledDifferent(d, criterion); };
  const double unbiased = normalCdf((normalQuantile(hits) - normalQuantile(alarms)) / 2);
  if (hits > alarms) {
    found.differencing = whereRisingPasses(hits, 0, farthest, shareAt);
    found.independent = 2 * normalQuantile((1 + std::sqrt(2 * unbiased - 1)) / 2);
  }
  const double hitShare = shareOf(c.hits, c.different), alarmShare = shareOf(c.falseAlarms, c.same);
  const bool apart = hitShare > alarmShare;
  const double best = apart ? likelihood(c, hitShare, alarmShare) : profile(c, 0);
  const auto lost = [&](double d) { return best - profile(c, d); };
  const double middle = apart ? found.differencing : 0;
  if (lost(0) > drop) found.low = whereRisingPasses(-drop, 0, middle, [&](double d) { return -lost(d); });
  constexpr double unbounded = 15;  // at this distance shares are exactly 0 or 1
  if (lost(unbounded) > drop) found.high = whereRisingPasses(drop, middle, unbounded, lost);
  return found;
}

double guessedP(const std::vector<SameDifferentCount>& persons) {
  std::vector<double> all{1};
  for (const SameDifferentCount& person : persons) {
    const std::vector<double> own = hitChances(person);
    std::vector<double> sum(all.size() + own.size() - 1, 0.0);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < own.size(); ++k) sum[i + k] += all[i] * own[k];
    all = std::move(sum);
  }
  double p = 0;
  for (std::size_t i = all.size(); i-- > sumOf(persons).hits;) p += all[i];
  return std::min(p, 1.0);
}

}  // namespace detent::playback
