// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/check.h"
#include "playback/study/statistics/shuffle.h"

namespace detent::playback {

namespace {

std::vector<double> ranksOf(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t from = 0; from < order.size();) {
    std::size_t to = from;
    while (to < order.size() && values[order[to]] == values[order[from]]) ++to;
    for (std::size_t i = from; i < to; ++i) ranks[order[i]] = static_cast<double>(from + to - 1) / 2;
    from = to;
  }
  return ranks;
}

}  // namespace

double spearman(const std::vector<double>& x, const std::vector<double>& y) {
  DETENT_CHECK(x.size() == y.size(), "one rank for each of both lists");
  if (x.size() < 2) return 0;
  const std::vector<double> a = ranksOf(x), b = ranksOf(y);
  const double mean = static_cast<double>(x.size() - 1) / 2;  // the mean of any complete ranking
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean) * (b[i] - mean);
    aa += (a[i] - mean) * (a[i] - mean);
    bb += (b[i] - mean) * (b[i] - mean);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

double spearmanP(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr std::size_t shuffles = 9999;
  constexpr std::uint64_t seed = 19040115;
  constexpr double roundOff = 1e-12;
  const double observed = spearman(x, y);
  if (observed == 0) return 1;
  StudyRandom random(seed);
  std::vector<double> shuffled = y;
  std::size_t asHigh = 1;  // the observed order is one of them
  for (std::size_t i = 0; i < shuffles; ++i) {
    shuffle(shuffled, random);
    if (spearman(x, shuffled) >= observed - roundOff) ++asHigh;
  }
  return static_cast<double>(asHigh) / static_cast<double>(shuffles + 1);
}

}  // namespace detent::playback
