// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Portable sine for the callback: the same bits on every machine (libm picks code by processor), no call, no
// table.

namespace detent::playback {

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
