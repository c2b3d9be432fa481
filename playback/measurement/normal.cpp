// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/normal.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "playback/measurement/root.h"

namespace detent::playback {

double normalCdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double normalQuantile(double p) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (p <= 0) return -infinity;
  if (p >= 1) return infinity;
  constexpr double farthest = 40;  // beyond this the distribution is exactly 0 or 1
  return whereRisingPasses(p, -farthest, farthest, normalCdf);
}

double studentCdf(double t, std::size_t degrees) {
  const double angle = std::atan(t / std::sqrt(static_cast<double>(degrees)));
  const double sine = std::sin(angle), cosine = std::cos(angle), square = cosine * cosine;
  const bool odd = degrees % 2 == 1;
  double term = odd ? cosine : 1, sum = 0;
  for (std::size_t i = odd ? 3 : 2; i <= degrees; i += 2) {
    sum += term;
    term *= square * static_cast<double>(i - 1) / static_cast<double>(i);
  }
  const double within = odd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum;
  return 0.5 * (1 + within);
}

double studentQuantile(double p, std::size_t degrees) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (p <= 0) return -infinity;
  if (p >= 1) return infinity;
  constexpr double farthest = 1e9;  // large, because one degree of freedom has heavy tails
  return whereRisingPasses(p, -farthest, farthest, [degrees](double t) { return studentCdf(t, degrees); });
}

}  // namespace detent::playback
