// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The coarse path of one colour's curve over the plot area: of all lines that never run back in x, the one
// that explains the most pixels for the least bridged paper. Gaps (legend boxes, dashes, text) are bridged;
// under another curve bridging is cheap, because the line may be hidden there.

#include <vector>

#include "importer/trace/colour_palette.h"
#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// Planes for the search of one curve, of the area's size.
struct CurveField {
  Plane own;                ///< coverage by the curve's colour; 0 where it is known to be something else
  Plane otherCurves;        ///< coverage by other curves, which may hide the curve
  Plane clutter;            ///< text and unexplained marks: may hide it too, but their direction says nothing
  std::vector<Box> opaque;  ///< legend boxes, which hide everything behind them
};

struct FollowOptions {
  double paperCost = 0.5;     ///< per bridged pixel of paper, in explained pixels; (0, 10]
  double hiddenCost = 0.1;    ///< per pixel under another curve
  double clutterCost = 0.35;  ///< per pixel under text
  double opaqueCost = 0.03;   ///< per pixel behind a legend box
  double thickness_px = 1;    ///< of the line, see lineThickness
  double riseCost = 0.03;     ///< per pixel of rise or fall on the curve, away from the ends
};

struct CoarseCurve {
  std::vector<Point> points;     ///< area pixels, in steps of one pixel right, up or down
  double gain_px = 0;            ///< columns (and steep ends) explained, minus bridging costs
  double coveredShare = 0;       ///< covered share of the pixels that are not hidden
  double coveredColumns_px = 0;  ///< columns with its own colour
  double span_px = 0;            ///< from the first to the last column
  double rise_px = 0;            ///< from the lowest to the highest row
  bool found() const { return points.size() > 1; }
};

CoarseCurve followCurve(const CurveField& field, const Box& within, const FollowOptions& options = {});

/// Typical thickness of the colour's lines, px: area over length of thin runs; >= 1.
double lineThickness(const Plane& own);

}  // namespace detent::importer::trace
