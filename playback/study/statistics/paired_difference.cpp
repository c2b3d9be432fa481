// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/paired_difference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "playback/study/statistics/shuffle.h"

namespace detent::playback {

namespace {

constexpr std::size_t mostEnumerated = 20;  // a million sign patterns, which take some milliseconds
constexpr std::size_t randomPatterns = 100000;
constexpr std::uint64_t seed = 19350101;
// share of the sum of all |differences|; sums in another order of addition count as equal
constexpr double roundOff = 1e-12;

/// Calls `visit(sum over the members, size)` for every subset of `values`, or for many random ones. Subsets
/// and sign patterns are equivalent: flipping the members subtracts twice their sum.
template <class Visit>
void forSubsets(const std::vector<double>& values, Visit visit) {
  const std::size_t n = values.size();
  if (n <= mostEnumerated) {
    double sum = 0;
    std::uint32_t members = 0;
    visit(0.0, std::size_t{0});
    // Gray code: one member is added or removed at a time
    for (std::uint32_t i = 1; i < (std::uint32_t{1} << n); ++i) {
      const int changed = std::countr_zero(i);
      members ^= std::uint32_t{1} << changed;
      const double value = values[static_cast<std::size_t>(changed)];
      sum += (members >> changed & 1U) != 0 ? value : -value;
      visit(sum, static_cast<std::size_t>(std::popcount(members)));
    }
    return;
  }
  StudyRandom random(seed);
  visit(0.0, std::size_t{0});  // the observed pattern is one of them
  for (std::size_t i = 0; i < randomPatterns; ++i) {
    double sum = 0;
    std::size_t size = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (drawBelow(random, 2) == 0) continue;
      sum += values[k];
      ++size;
    }
    visit(sum, size);
  }
}

}  // namespace

PairedDifference pairedDifference(const std::vector<double>& differences, double confidence) {
  PairedDifference result;
  if (differences.empty()) return result;
  const double total = std::accumulate(differences.begin(), differences.end(), 0.0);
  const double size = std::accumulate(differences.begin(), differences.end(), 0.0,
                                      [](double sum, double d) { return sum + std::fabs(d); });
  result.mean = std::fabs(total) <= roundOff * size ? 0 : total / static_cast<double>(differences.size());
  std::size_t patterns = 0, asFar = 0;
  std::vector<double> means;
  forSubsets(differences, [&](double sum, std::size_t members) {
    ++patterns;
    if (std::fabs(total - 2 * sum) >= std::fabs(total) - roundOff * size) ++asFar;
    if (members > 0) means.push_back(sum / static_cast<double>(members));
  });
  result.p = static_cast<double>(asFar) / static_cast<double>(patterns);
  const auto outside =
      static_cast<std::size_t>((1 - confidence) / 2 * static_cast<double>(patterns) * (1 + roundOff));
  if (outside == 0) return result;
  const auto place = [&](std::size_t rank) {
    std::nth_element(means.begin(), means.begin() + static_cast<std::ptrdiff_t>(rank), means.end());
    return means[rank];
  };
  result.interval = Interval{place(outside - 1), place(means.size() - outside)};
  return result;
}

}  // namespace detent::playback
