// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What of the ink is not curve: straight lines across the frame (grid, frame edges, guide lines), lettering.
// In: the work plane. Out: a reward per pixel for a curve that passes there.

#include <vector>

#include "importer/trace/work_plane.h"

namespace detent::importer::trace {

/// A line along a whole row or column of the plane, as it is drawn: solid or dashed, any darkness.
struct StraightLine {
  bool vertical = false;
  int position = 0;            ///< column or row of its middle, plane px
  int reach = 0;               ///< the profile covers position-reach .. position+reach
  std::vector<float> profile;  ///< its own coverage across, free of what crosses it
  float level = 0;             ///< coverage in its middle

  float at(int offset) const {
    return offset < -reach || offset > reach ? 0.0F : profile[static_cast<std::size_t>(offset + reach)];
  }
};

/// Lines that run across the frame. `expected` are positions known from the frame finder (plane px); they are
/// looked for with less evidence than others. Curve walls are no such lines: they end at the knee.
std::vector<StraightLine> findStraightLines(const WorkPlane& plane,
                                            const std::vector<double>& expectedColumns,
                                            const std::vector<double>& expectedRows);

/// The ink with its straight lines explained away.
struct Structure {
  Plane explained;       ///< coverage the straight lines account for, where they are drawn
  Plane upright;         ///< the part of it that vertical lines inside the frame account for
  Plane curveInk;        ///< 0..1: what is left, in units of the curves' own darkness
  Plane gapDistance;     ///< px to the nearest left-over ink that is no lettering
  float curveLevel = 1;  ///< coverage of the curves' ridge
  double strokeWidth_px = 1;
};

/// `lettering`: boxes of read text, plane px; ink wholly inside is no curve.
Structure explainStructure(const WorkPlane& plane, const std::vector<StraightLine>& lines,
                           const std::vector<Box>& lettering);

/// What a pixel of paper costs on a path: so much, and more with the distance to the nearest ink.
struct GapPrice {
  float perPixel = 0.6F;
  float perPixelOfDistance = 0.4F;
};

/// Gain per pixel of path length: 1 on curve ink, below 0 on explained lines and on paper, so that short gaps
/// are cheap and leaps to other ink are not.
Plane rewardOf(const Structure& structure, const WorkPlane& plane, const GapPrice& price);

}  // namespace detent::importer::trace
