// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines that a plotting program rounded to whole pixels: what the unrounded, evenly spaced ones must have
// been.

#include <optional>
#include <utility>
#include <vector>

namespace detent::importer {

/// value = offset + perPx * position.
struct ValueLine {
  double offset = 0, perPx = 0;
};

/// Positions (px) with values. If all positions share one fraction of a pixel, each true place lies within
/// half a pixel of them; the middle of all relations that obey this is far closer than least squares, for
/// rounding is no noise: its errors are bounded, so they fall with the number of lines, not with its root.
/// nullopt if the positions are not rounded or no relation obeys.
std::optional<ValueLine> throughRoundedLines(const std::vector<std::pair<double, double>>& positionValue);

}  // namespace detent::importer
