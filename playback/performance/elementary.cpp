// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/elementary.h"

#include <cmath>
#include <numbers>

#include "model/check.h"

namespace detent::playback {

double exponential(double x) {
  DETENT_CHECK(x >= -700 && x <= 700, "the exponent of a finite value");
  if (x < 0) return 1 / exponential(-x);
  constexpr int halvings = 12;  // |x| / 4096 < 0.18, so fourteen terms are exact to the last bit
  double small = x;
  for (int i = 0; i < halvings; ++i) small *= 0.5;
  // expm1 by its series, then doubled repeatedly as (1 + m)^2 - 1 = m (2 + m), so that no digits are lost for
  // small arguments.
  double minusOne = 0;
  for (int n = 14; n >= 1; --n) minusOne = small / n * (1 + minusOne);
  for (int i = 0; i < halvings; ++i) minusOne *= 2 + minusOne;
  return 1 + minusOne;
}

SineCosine sineAndCosine(double x) {
  double sine = 1, cosine = 1;
  for (int n = 12; n >= 1; --n) {
    sine = 1 - x * x / (2.0 * n * (2.0 * n + 1)) * sine;
    cosine = 1 - x * x / (2.0 * n * (2.0 * n - 1)) * cosine;
  }
  return {x * sine, cosine};
}

double errorFunction(double x) {
  if (x < 0) return -errorFunction(-x);
  if (x > 6) return 1;
  // exp(-x^2) times a series of positive terms (Abramowitz & Stegun 7.1.6).
  double term = x, sum = x;
  for (int n = 1; term > 1e-18 * sum; ++n) {
    term *= 2 * x * x / (2.0 * n + 1);
    sum += term;
  }
  return 2 * std::numbers::inv_sqrtpi * exponential(-x * x) * sum;
}

double normalShare(double z) { return 0.5 * (1 + errorFunction(z / std::numbers::sqrt2)); }

double normalScore(double share) {
  DETENT_CHECK(share > 0 && share < 1, "a share inside (0, 1)");
  double low = -8, high = 8;
  for (int i = 0; i < 54; ++i) {
    const double middle = 0.5 * (low + high);
    (normalShare(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<double> normalScores(int count) {
  std::vector<double> scores;
  for (int i = 0; i < count; ++i) scores.push_back(normalScore((i + 0.5) / count));
  return scores;
}

std::uint64_t FixedRandom::next() {
  state_ += 0x9E3779B97F4A7C15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

double FixedRandom::share() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

double FixedRandom::normal() { return normalScore((static_cast<double>(next() >> 12U) + 0.5) * 0x1p-52); }

}  // namespace detent::playback
