// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/binomial.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "playback/measurement/normal.h"
#include "playback/measurement/root.h"

namespace detent::playback {

namespace {

double logChoose(double n, double k) {
  return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
}

}  // namespace

double rateOf(const Count& count) {
  return count.trials == 0 ? 0 : static_cast<double>(count.errors) / static_cast<double>(count.trials);
}

double atMost(const Count& count, double rate) {
  if (count.errors >= count.trials || rate <= 0) return 1;
  if (rate >= 1) return 0;
  const auto n = static_cast<double>(count.trials);
  double sum = 0;
  for (std::size_t i = 0; i <= count.errors; ++i) {
    const auto k = static_cast<double>(i);
    sum += std::exp(logChoose(n, k) + k * std::log(rate) + (n - k) * std::log1p(-rate));
  }
  return std::min(sum, 1.0);
}

Interval wilson(const Count& count, double confidence) {
  if (count.trials == 0) return {};
  const double z = normalQuantile(0.5 + confidence / 2), n = static_cast<double>(count.trials);
  const double p = rateOf(count), shrink = 1 + z * z / n;
  const double centre = (p + z * z / (2 * n)) / shrink;
  const double half = z / shrink * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {count.errors == 0 ? 0 : centre - half, count.errors >= count.trials ? 1 : centre + half};
}

Interval clopperPearson(const Count& count, double confidence) {
  if (count.trials == 0) return {};
  const double tail = (1 - confidence) / 2;
  Interval interval;
  if (count.errors > 0) {  // P(at least as many errors) increases with the rate
    interval.low = whereRisingPasses(tail, 0, 1, [&](double rate) {
      return 1 - atMost({count.errors - 1, count.trials}, rate);
    });
  }
  if (count.errors < count.trials) {
    interval.high = whereRisingPasses(-tail, 0, 1, [&](double rate) { return -atMost(count, rate); });
  }
  return interval;
}

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    largest = std::max(largest, std::min(1.0, p[order[rank]] * static_cast<double>(p.size() - rank)));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

Count sumOf(const std::vector<Count>& counts) {
  Count sum;
  for (const Count& c : counts) {
    sum.errors += c.errors;
    sum.trials += c.trials;
  }
  return sum;
}

}  // namespace detent::playback
