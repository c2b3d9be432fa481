// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke curve as a table of at most maxTablePoints vertices, as close to the curve as that number allows.

#include <vector>

#include "model/stroke_curve.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

struct TableFit {
  std::vector<TablePoint> points;  ///< by increasing displacement, from `from_mm` to `to_mm`
  double error_N = 0;              ///< largest vertical distance from the curve at the examined displacements
};

/// Vertices at every displacement in `kept_mm` (section ends, in any order); vertical rises as two vertices;
/// the others where the curve bends most. Beyond the curve the force of its end continues. Forces below
/// `lowest_N` are raised to it. kept_mm.size() <= maxTablePoints / 4.
TableFit fitTable(const StrokeCurve& curve, double from_mm, double to_mm, double lowest_N,
                  const std::vector<double>& kept_mm);

}  // namespace detent::playback
