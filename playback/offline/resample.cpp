// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/offline/resample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace detent::playback {

namespace {
constexpr double zeroCrossings = 32;

/// Blackman window over [-1, 1].
double window(double x) {
  if (std::fabs(x) >= 1) return 0;
  return 0.42 + 0.5 * std::cos(std::numbers::pi * x) + 0.08 * std::cos(2 * std::numbers::pi * x);
}

double sinc(double x) { return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); }

/// Half of the kernel in steps of 1/512 of a zero crossing; linear interpolation is accurate to 2e-6.
constexpr std::size_t perCrossing = 512;
const std::vector<double>& kernel() {
  static const std::vector<double> half = [] {
    std::vector<double> weights;
    for (double step = 0; step <= zeroCrossings * perCrossing; ++step)
      weights.push_back(sinc(step / perCrossing) * window(step / perCrossing / zeroCrossings));
    return weights;
  }();
  return half;
}

double weight(const std::vector<double>& half, double crossings) {
  const double step = std::fabs(crossings) * perCrossing;
  const auto at = static_cast<std::size_t>(step);
  if (at + 1 >= half.size()) return 0;
  return half[at] + (step - static_cast<double>(at)) * (half[at + 1] - half[at]);
}
}  // namespace

std::vector<float> resampled(const std::vector<float>& samples, double from_Hz, double to_Hz) {
  if (from_Hz == to_Hz || samples.empty()) return samples;
  const double ratio = to_Hz / from_Hz;
  const double cut = std::min(1.0, ratio);  // share of the frequency band that is kept
  const double reach = zeroCrossings / cut;
  const auto count = static_cast<std::size_t>(std::ceil(static_cast<double>(samples.size()) * ratio));
  const auto last = static_cast<std::ptrdiff_t>(samples.size()) - 1;
  std::vector<float> result(count);
  const std::vector<double>& half = kernel();
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) / ratio;
    const auto from = std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(std::ceil(at - reach)));
    const auto to = std::min(last, static_cast<std::ptrdiff_t>(std::floor(at + reach)));
    double sum = 0;
    for (std::ptrdiff_t k = from; k <= to; ++k) {
      const double away = static_cast<double>(k) - at;
      sum += static_cast<double>(samples[static_cast<std::size_t>(k)]) * cut * weight(half, cut * away);
    }
    result[i] = static_cast<float>(sum);
  }
  return result;
}

}  // namespace detent::playback
