// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What of the page a result leaves unexplained: the curves are drawn back onto the plot with the plot's lines and words,
// and what ink remains is looked at. Pixels of the view, so that documents and pictures are judged alike.

#include <vector>

#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Connected ink in a curve's colour that no curve, line or word of the plot explains.
struct Remainder {
  Box box_px;                 ///< view pixels
  std::vector<Point> ink_px;  ///< its pixels, thinned to some hundred; view pixels
  double length = 0;          ///< of its extent, share of the plot's diagonal
  double width = 0;           ///< of its extent along the displacement axis, share of the plot's width
  double thickness = 0;       ///< in thicknesses of the curves
  bool straight = false;      ///< as leaders, guides and boxes are
  bool atAnEnd = false;       ///< begins where a curve ends
  bool dashed = false;        ///< a line of dashes by itself
  /// How much it looks like a curve, 0..1: long, thin, bent, or the straight continuation of a curve's end.
  double likeness = 0;
};

/// Where a curve crosses bare paper in a direction that its ink does not have on both sides.
struct Leap {
  Point from_px, to_px;  ///< view pixels
  double length = 0;     ///< share of the plot's diagonal
};

/// Ink left over as no line makes it: solid over more than a line's thickness in every direction.
struct Patches {
  double share = 0;  ///< of their insides, in areas of the curves' ink
  Point at_px;       ///< in one of them, view pixels
};

/// The line that runs on what nothing explains, in whatever ink and however pale, above or below the one curve that was traced.
struct LineBeside {
  double share = 0;  ///< of the curve's travel, by columns with ink
  Point at_px;       ///< on it, view pixels
};

/// What of a plot a result does not explain, and what of the result the plot does not.
struct Explanation {
  std::vector<Remainder> left;  ///< the most curve-like first
  std::vector<Leap> leaps;      ///< the longest first
  Patches patches;              ///< in the curves' colours: what was followed may be a ground
  LineBeside beside;            ///< of a curve that was traced alone
};

/// `curves`: all that were traced, those of other switches too.
Explanation explain(const trace::PlotScene& scene, const std::vector<CurveTrace>& curves);

}  // namespace detent::importer
