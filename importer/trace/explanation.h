// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Unexplained marks of a result: the curves are drawn back onto the plot with its lines and words, and the
// remaining pixels are examined. On pixels of the view, so that documents and pictures are treated alike.

#include <vector>

#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Connected pixels in a curve's colour that no curve, line or word explains.
struct Remainder {
  Box box_px;                    ///< view pixels
  std::vector<Point> pixels_px;  ///< its pixels, thinned to a few hundred; view pixels
  double length = 0;             ///< of its extent, share of the plot's diagonal
  double width = 0;              ///< of its extent along the displacement axis, share of the plot's width
  double thickness = 0;          ///< in thicknesses of the curves
  bool straight = false;         ///< like leaders, marker lines and boxes
  bool atAnEnd = false;          ///< begins where a curve ends
  bool dashed = false;           ///< an isolated dashed line
  /// Likeness to a curve, 0..1: long, thin, bent, or the straight continuation of a curve's end.
  double likeness = 0;
};

/// A jump of the trace: it crosses bare paper in a direction that it does not have on both sides.
struct TraceJump {
  Point from_px, to_px;  ///< view pixels
  double length = 0;     ///< share of the plot's diagonal
};

/// Remaining solid patches, wider than a line in every direction.
struct Patches {
  double share = 0;  ///< area inside the outlines, relative to the area of the curves
  Point at_px;       ///< a point inside one of the outlines, view pixels
};

/// An unexplained line, of any colour and however pale, above or below the only traced curve.
struct LineBeside {
  double share = 0;  ///< of the curve's travel, by columns with pixels
  Point at_px;       ///< a point on the line, view pixels
};

/// Marks of a plot that a result does not explain, and places where the result has no support.
struct Explanation {
  std::vector<Remainder> left;   ///< most curve-like first
  std::vector<TraceJump> jumps;  ///< longest first
  Patches patches;               ///< in the curves' colours; the traced line may be the edge of a filled area
  LineBeside beside;             ///< only if a single curve was traced
};

/// `curves`: all traced ones, including those of other switches.
Explanation explain(const trace::PlotScene& scene, const std::vector<CurveTrace>& curves);

}  // namespace detent::importer
