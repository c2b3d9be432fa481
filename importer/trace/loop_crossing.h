// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Detects whether two strokes of one colour are the upper and lower outline of two crossing lines, like the
// presses of two switches (docs/develop/decisions/0809-several-curves-in-one-colour.md). Press and release of
// one switch may touch; they never cross.

#include <vector>

#include "importer/page/raster.h"

namespace detent::importer::trace {

/// Returns true if the upper and the lower line pass straight through each other: both bend away from each
/// other where they meet, and lines that exchange sides there go on straight. Lines that touch and separate
/// do not. Points in px, y downwards, about 1 px apart, left to right; `width_px`: of the lines, `size_px`:
/// the frame's diagonal.
bool linesCross(const std::vector<Point>& upper, const std::vector<Point>& lower, double width_px,
                double size_px);

}  // namespace detent::importer::trace
