// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From the page's paths to pieces of line that could belong to a curve. Private to importer/trace.

#include <vector>

#include "importer/frame/plot_frame.h"
#include "importer/page/page.h"
#include "importer/page/polyline.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Upright plot area in view pixels, with the positions of its lines.
struct PlotPlane {
  Box box;
  std::vector<double> columns_px, rows_px;  ///< gridlines that span the plot, and its edges

  explicit PlotPlane(const PlotFrame& frame);
  /// Share of the width from the left, 0..1 inside.
  double across(Point p) const { return (p.x - box.x0) / box.width(); }
  double diagonal() const;
};

/// An unbranched line, view pixels. Its x runs in one direction, except for deviations of a few per cent of
/// the plot's width.
struct LinePiece {
  std::vector<Point> points;  ///< at least two, successive ones distinct
  Rgb color;
  double width_px = 1;
  bool dashed = false;
  bool axisParallel = false;  ///< one straight horizontal or vertical line
  bool onGridLine = false;    ///< axis parallel, and lying on a line of the frame or grid
  bool small = false;         ///< letter size
};

/// Lines inside the plot (and a small margin, because curves may overshoot): clipped as in the document, cut
/// at masks, without boxes and closed letter shapes, cut where x turns round.
std::vector<LinePiece> linePieces(const PageView& view, const PlotPlane& plane,
                                  const std::vector<Box>& masks_px);

}  // namespace detent::importer
