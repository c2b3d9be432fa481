// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds rectangles of straight lines in which a graph could be: boxes, grids, open grids, two axis lines.

#include <array>
#include <vector>

#include "importer/frame/straight_lines.h"
#include "importer/page/raster.h"

namespace detent::importer {

/// A rectangle made of lines, in pixels of the plane.
struct PlotRectangle {
  Box box;
  std::array<double, 4> edgeCover{};  ///< left, top, right, bottom: share of the edge that is drawn
  std::vector<double> xLines,
      yLines;        ///< increasing positions of lines that span it, including drawn edges
  double score = 0;  ///< higher is more plot-like; comparable within one page
};

/// Best first within a group of touching lines; at least two adjacent edges are drawn.
std::vector<PlotRectangle> findPlotRectangles(const LineSet& lines, double minWidth_px, double minHeight_px);

}  // namespace detent::importer
