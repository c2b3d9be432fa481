// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The coarse course of one ink's curve over the plot area, found globally: of all lines that never run back
// in x, the one that explains the most ink for the least bridged paper. Gaps (legend boxes, dashes, text) are
// bridged; under another curve's ink bridging is cheap, because the line may be hidden there.

#include <vector>

#include "importer/trace/ink_palette.h"
#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// What one curve is looked for on. All planes have the area's size.
struct CurveField {
  Plane own;                ///< coverage of the curve's ink; 0 where it is known to be something else
  Plane otherCurves;        ///< coverage of other curves' inks: what may hide the curve
  Plane clutter;            ///< text and things unexplained: may hide it too, but its course says nothing
  std::vector<Box> opaque;  ///< legend boxes: whatever runs behind them is not seen
};

struct FollowOptions {
  double paperCost = 0.5;     ///< per bridged pixel of paper, in pixels of explained ink; (0, 10]
  double hiddenCost = 0.1;    ///< per pixel under another curve
  double clutterCost = 0.35;  ///< per pixel under text
  double opaqueCost = 0.03;   ///< per pixel behind a legend box
  double thickness_px = 1;    ///< of the line, see lineThickness
  double riseCost = 0.03;     ///< per pixel of rise or fall on ink, away from the ends
};

struct CoarseCurve {
  std::vector<Point> points;  ///< area pixels, steps of one pixel right, up or down
  double gain_px = 0;         ///< columns (and end walls) explained, minus bridging costs
  double inkShare = 0;        ///< of the pixels that are not hidden, how many are ink
  double inkColumns_px = 0;   ///< columns in which it meets ink of its own
  double span_px = 0;         ///< from the first to the last column
  double rise_px = 0;         ///< from the lowest to the highest row
  bool found() const { return points.size() > 1; }
};

CoarseCurve followCurve(const CurveField& field, const Box& within, const FollowOptions& options = {});

/// Typical thickness of the ink's lines, px: area over length of thin runs; >= 1.
double lineThickness(const Plane& own);

}  // namespace detent::importer::trace
