// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sub-pixel positions of lines: centroids of darkness across them.

#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "importer/frame/plot_frame.h"

namespace detent::importer {

/// Mean darkness of columns [x0, x1) over rows [y0, y1), inside the plane.
std::vector<double> meanColumns(const cv::Mat& darkness, int x0, int x1, int y0, int y1);

/// An edge of the frame: position across it as a linear function of the position along it.
struct EdgeLine {
  double at0 = 0, slope = 0;  ///< across = at0 + slope * along
  double width_px = 1;
  double support = 0;  ///< share of its length where it is visible
  double across(double along) const { return at0 + slope * along; }
};

/// The line near `across` on [from, to] (along = row, across = column); nullopt if less than a third of it is
/// visible.
std::optional<EdgeLine> locateColumnEdge(const cv::Mat& darkness, double across, double from, double to,
                                         double reach);

/// Coverage of the pixels beside a line's crest near column `across`, as shares of the crest's darkness:
/// left, right, and two pixels away. Median over [from, to].
struct RimCover {
  double left = 0, right = 0, beyond = 0;
};
std::optional<RimCover> rimCover(const cv::Mat& darkness, double across, double from, double to);

/// Lines that cross the whole strip of rows [top, bottom], left to right: gridlines of an upright rectangle.
std::vector<GridLine> columnLines(const cv::Mat& darkness, double left, double right, double top,
                                  double bottom);

/// Marks in a narrow strip of rows beside an axis, left to right: ticks.
std::vector<GridLine> columnTicks(const cv::Mat& darkness, double left, double right, double stripTop,
                                  double stripBottom);

}  // namespace detent::importer
