// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Separates the curve from straight lines across the frame (grid, edges, marker lines) and text. In: the work
// plane. Out: a reward per pixel for a curve.

#include <vector>

#include "importer/trace/work_plane.h"

namespace detent::importer::trace {

/// A line along a whole row or column of the plane: solid or dashed, any darkness.
struct StraightLine {
  bool vertical = false;
  int position = 0;            ///< column or row of its middle, plane px
  int reach = 0;               ///< the profile covers position-reach .. position+reach
  std::vector<float> profile;  ///< own coverage across the line, without what crosses it
  float level = 0;             ///< coverage in its middle

  float at(int offset) const {
    return offset < -reach || offset > reach ? 0.0F : profile[static_cast<std::size_t>(offset + reach)];
  }
};

/// Lines that run across the frame. `expected`: positions known from the frame finder (plane px), accepted
/// with less evidence. Steep stretches of curves are no such lines, because they end at a corner.
std::vector<StraightLine> findStraightLines(const WorkPlane& plane,
                                            const std::vector<double>& expectedColumns,
                                            const std::vector<double>& expectedRows);

/// The coverage with its straight lines subtracted.
struct Structure {
  Plane explained;          ///< coverage explained by the straight lines where they are drawn
  Plane upright;            ///< the part of it that vertical lines inside the frame explain
  Plane remainingCoverage;  ///< 0..1: the rest, in units of the curves' own darkness
  Plane gapDistance;        ///< px to the nearest remaining pixel that is no text
  float curveLevel = 1;     ///< coverage of the curves' ridge
  double strokeWidth_px = 1;

  static constexpr float leastOfLine = 0.3F;  ///< share of `curveLevel` from which on a line is seen
  /// Returns true if a straight line of the plot is drawn at a pixel of the plane.
  bool isOnLine(int x, int y) const { return explained.at(x, y) > leastOfLine * curveLevel; }
};

/// `lettering`: boxes of read text, plane px; marks completely inside are no curve.
Structure explainStructure(const WorkPlane& plane, const std::vector<StraightLine>& lines,
                           const std::vector<Box>& lettering);

/// Price of a pixel of paper on a path: a constant, plus a part that grows with the distance to the nearest
/// mark.
struct GapPrice {
  float perPixel = 0.6F;
  float perPixelOfDistance = 0.4F;
};

/// Gain per pixel of path length: 1 on the curve, below 0 on explained lines and on paper, so that short gaps
/// are cheap and jumps to other marks are not.
Plane rewardOf(const Structure& structure, const WorkPlane& plane, const GapPrice& price);

}  // namespace detent::importer::trace
