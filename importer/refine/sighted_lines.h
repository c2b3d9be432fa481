// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measures where the lines of a plot really run: gridlines, edges and ticks of known axes, each at many
// places.

#include <optional>
#include <vector>

#include "importer/axes/axis_calibration.h"
#include "importer/page/page.h"

namespace detent::importer {

/// One line of equal displacement or equal force, as drawn.
struct SightedLine {
  /// true: a horizontal line of equal force; false: a vertical one of equal displacement
  bool ofForce = false;
  double about = 0;  ///< mm or N by the calibration with which it was searched
  /// mm or N if a label or the user gives it; otherwise the line is only known to have one value
  std::optional<double> value;
  std::vector<Point> points_px;  ///< view pixels, sub-pixel across the line, in order along it; 1 for a tick
};

/// The plot's lines in a view, searched near their positions by the calibration. Lines of which less than a
/// third is visible, or that lie within 3 px of another, are left out. Any thread.
std::vector<SightedLine> sightLines(const PageView& view, const PlotFrame& frame,
                                    const AxisCalibration& calibration);

}  // namespace detent::importer
