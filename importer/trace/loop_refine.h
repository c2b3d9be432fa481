// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From paths on the work plane to sub-pixel lines in the view. Across each stroke a profile is compared with
// a model: one line of the measured width, or two where the strokes run close (merged into one band, the
// lines lie at its edges, inset by half a width). Profiles covered by a gridline are unknown and left to
// their neighbours.

#include <vector>

#include "importer/trace/loop_pair.h"
#include "importer/trace/loop_structure.h"

namespace detent::importer::trace {

struct RefinedStroke {
  std::vector<Point> points;  ///< area pixels, by increasing displacement, about 1 px apart
  double width_px = 1;        ///< of its line
  std::vector<double> trust;  ///< 0..1 per point: fit of the line model; 0 = interpolated
};

struct RefinedPair {
  RefinedStroke press, release;
};

/// Refines on the area's coverage from which the plane was shrunk.
RefinedPair refinePair(const PlanePair& pair, const WorkPlane& plane, const Plane& coverage,
                       const std::vector<StraightLine>& lines, const Structure& structure);

}  // namespace detent::importer::trace
