// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/statistics/normal.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "playback/statistics/root.h"

namespace detent::playback {

double normalCdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double normalQuantile(double p) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (p <= 0) return -infinity;
  if (p >= 1) return infinity;
  constexpr double farthest = 40;  // beyond, the distribution is 0 or 1 to the last bit
  return whereRisingPasses(p, -farthest, farthest, normalCdf);
}

}  // namespace detent::playback
