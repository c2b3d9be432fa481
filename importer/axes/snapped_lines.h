// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reconstructs evenly spaced lines that a plotting program has rounded to whole pixels.

#include <optional>
#include <utility>
#include <vector>

namespace detent::importer {

/// value = offset + perPx * position.
struct ValueLine {
  double offset = 0, perPx = 0;
};

/// `positions` (px) with values. If all positions have the same fraction of a pixel, they were rounded, and
/// each true position lies within half a pixel. Returns the centre of all linear relations that satisfy these
/// bounds. That is far more accurate than least squares: rounding errors are bounded, so the error falls with
/// the number of lines, not with its square root. nullopt if the positions were not rounded or no relation
/// satisfies the bounds.
std::optional<ValueLine> throughRoundedLines(const std::vector<std::pair<double, double>>& positionValue);

}  // namespace detent::importer
