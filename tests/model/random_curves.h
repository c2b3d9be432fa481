// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Curves for property tests: any shape, with corners, vertical rises and flats.

#include <vector>

#include <rapidcheck.h>

#include "model/stroke_curve.h"

namespace detent::tests {

inline double between(double low, double high) {
  return low + (high - low) * (*rc::gen::inRange(0, 1000001)) / 1000000.0;
}

/// 2 to 13 knots from 0 mm on, travel up to about 6 mm, forces of 0 to 2 N, one piece in ten a vertical rise,
/// one in ten flat.
inline StrokeCurve anyCurve() {
  std::vector<Knot> knots;
  const int count = *rc::gen::inRange(2, 14);
  double x = 0;
  bool bottomOutBefore = true;
  for (int i = 0; i < count; ++i) {
    const int kind = *rc::gen::inRange(0, 10);
    const bool isBottomOut = kind == 0 && !bottomOutBefore && i + 1 < count;
    if (i > 0 && !isBottomOut) x += between(0.01, 0.5);
    bottomOutBefore = isBottomOut || i == 0;
    Knot k{x, between(0, 2), between(-4, 4), between(-4, 4)};
    if (kind == 1 && i > 0 && !isBottomOut) {
      k.force_N = knots.back().force_N;
      knots.back().slopeAfter_N_per_mm = 0;
      k.slopeBefore_N_per_mm = 0;
    }
    knots.push_back(k);
  }
  auto curve = StrokeCurve::fromKnots(knots);
  RC_ASSERT(curve.ok());
  return *curve;
}

}  // namespace detent::tests
