// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A sine for the callback with the same bits on every machine (the mathematics library chooses code by
// processor); no function call, no table.

#include <cmath>

namespace detent::playback {

/// Cycles from one sample to the next, without whole cycles, which make no difference; 0 (silence) if not a
/// number.
inline double cyclesPerSample(double frequency_Hz, double sampleRate_Hz) {
  return std::isfinite(frequency_Hz) ? std::fmod(frequency_Hz, sampleRate_Hz) / sampleRate_Hz : 0;
}

/// Length of a burst in samples, limited to what can be counted exactly.
inline double samplesIn(double duration_s, double sampleRate_Hz) {
  return std::fmin(duration_s * sampleRate_Hz, 0x1p53);
}

/// sin(2*pi*phase), phase in cycles within [0, 1]. Absolute error < 1e-12.
inline double sineOfCycles(double phase) {
  // Fold to [-1/4, 1/4] cycle, then the Taylor polynomial of degree 17 (next term 4e-14 at the edge).
  double x = phase;
  if (x > 0.75) {
    x -= 1.0;
  } else if (x > 0.25) {
    x = 0.5 - x;
  }
  x *= 6.283185307179586476925286766559;
  const double s = x * x;
  double p = 1.0 / 355687428096000.0;
  p = -1.0 / 1307674368000.0 + s * p;
  p = 1.0 / 6227020800.0 + s * p;
  p = -1.0 / 39916800.0 + s * p;
  p = 1.0 / 362880.0 + s * p;
  p = -1.0 / 5040.0 + s * p;
  p = 1.0 / 120.0 + s * p;
  p = -1.0 / 6.0 + s * p;
  return x + x * s * p;
}

}  // namespace detent::playback
