// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/statistics/abx_sensitivity.h"

#include <cmath>
#include <limits>

#include "playback/measurement/normal.h"
#include "playback/measurement/root.h"

namespace detent::playback {

double shareCorrect(double dPrime, AbxStrategy strategy) {
  const double first = dPrime / std::sqrt(2.0);
  const double second = strategy == AbxStrategy::differencing ? dPrime / std::sqrt(6.0) : dPrime / 2;
  return normalCdf(first) * normalCdf(second) + normalCdf(-first) * normalCdf(-second);
}

double dPrimeOf(double share, AbxStrategy strategy) {
  if (!(share > 0.5)) return 0;
  if (share >= 1) return std::numeric_limits<double>::infinity();
  constexpr double farthest = 40;  // the share is exactly 1 long before this
  return whereRisingPasses(share, 0, farthest, [&](double d) { return shareCorrect(d, strategy); });
}

}  // namespace detent::playback
