// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where the lines of a plot really run: gridlines, edges and ticks of known axes, seen at many places along
// each.

#include <optional>
#include <vector>

#include "importer/axes/axis_calibration.h"
#include "importer/page/page.h"

namespace detent::importer {

/// One line of equal displacement or equal force, as drawn.
struct SightedLine {
  bool ofForce = false;         ///< a level line; else one of equal displacement
  double about = 0;             ///< mm or N by the calibration it was looked for with
  std::optional<double> value;  ///< mm or N, if a label or the user gives it; else only known to be one value
  std::vector<Point> points_px;  ///< view pixels, sub-pixel across the line, in order along it; 1 for a tick
};

/// The plot's lines in a view, looked for where the calibration has them. Lines of which less than a third is
/// seen, or that stand within 3 px of another, are left out. Any thread.
std::vector<SightedLine> sightLines(const PageView& view, const PlotFrame& frame,
                                    const AxisCalibration& calibration);

}  // namespace detent::importer
