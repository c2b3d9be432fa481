// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/latency_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

double percentile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (place - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

}  // namespace

LatencyStatistics statisticsOf(std::vector<double> delays_s, std::size_t lost) {
  LatencyStatistics s;
  s.lost = lost;
  s.n = delays_s.size();
  if (delays_s.empty()) return s;
  std::sort(delays_s.begin(), delays_s.end());
  double sum = 0, squares = 0;
  for (double d : delays_s) sum += d;
  s.mean_s = sum / static_cast<double>(s.n);
  for (double d : delays_s) squares += (d - s.mean_s) * (d - s.mean_s);
  s.sd_s = s.n > 1 ? std::sqrt(squares / static_cast<double>(s.n - 1)) : 0;
  s.min_s = delays_s.front();
  s.max_s = delays_s.back();
  s.p5_s = percentile(delays_s, 0.05);
  s.median_s = percentile(delays_s, 0.5);
  s.p95_s = percentile(delays_s, 0.95);
  s.p99_s = percentile(delays_s, 0.99);
  s.sorted_s = std::move(delays_s);
  return s;
}

std::string histogram(const LatencyStatistics& s, int bins) {
  if (s.n == 0 || bins < 1) return "";
  const double width = std::max((s.max_s - s.min_s) / bins, 1e-6);
  std::vector<std::size_t> counts(static_cast<std::size_t>(bins), 0);
  for (double d : s.sorted_s) {
    const auto bin = static_cast<std::size_t>((d - s.min_s) / width);
    ++counts[std::min(bin, counts.size() - 1)];
  }
  const std::size_t most = *std::max_element(counts.begin(), counts.end());
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    char line[40];
    std::snprintf(line, sizeof line, "%9.3f ms %5zu ", 1e3 * (s.min_s + width * static_cast<double>(i)),
                  counts[i]);
    text += line + std::string((counts[i] * 50 + most - 1) / most, '#') + "\n";
  }
  return text;
}

std::string latencyCsv(const LatencyStatistics& s) {
  std::string text = "latency_s\n";
  for (double d : s.sorted_s) text += exact(d) + "\n";
  return text;
}

}  // namespace detent::playback
