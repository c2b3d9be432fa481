// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Statistics of measured delays, as Kim & Lee state them ("about 51.12ms (N = 50, SD = 1.65)"), and further
// ones.

#include <string>
#include <vector>

#include "playback/prepare/device_profile.h"

namespace detent::playback {

struct LatencyStatistics {
  std::size_t n = 0;
  std::size_t lost = 0;  ///< trials without an answer
  double mean_s = 0, sd_s = 0, min_s = 0, max_s = 0;
  double p5_s = 0, median_s = 0, p95_s = 0, p99_s = 0;
  std::vector<double> sorted_s;

  MeasuredLatency forProfile() const { return {n, mean_s, sd_s, p95_s}; }
};

/// Percentiles by linear interpolation between order statistics; SD with n - 1.
LatencyStatistics statisticsOf(std::vector<double> delays_s, std::size_t lost);

/// Lines of '#', one per bin (`bins` >= 1) between min and max, with the bin's lower edge in ms and its
/// count.
std::string histogram(const LatencyStatistics& statistics, int bins);

std::string latencyCsv(const LatencyStatistics& statistics);

}  // namespace detent::playback
