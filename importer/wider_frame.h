// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A plot may continue beyond the last gridline that has a number, and its curves with it. The frame is then
// widened to the ends of the curves. Any thread.

#include <optional>
#include <vector>

#include "importer/locate_graphs.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Returns true if pixels of this colour are on a straight line beyond a curve's end, seen at three
/// positions.
bool goesOnBeyond(const std::vector<Point>& curve, Rgb color, const Raster& picture);

/// The graph with its right and upper edges moved to the ends of its curves' pixels, and the scales extended
/// accordingly. Upwards the frame goes at least to the last tick label. Empty if no curve leaves the frame
/// there, if the frame is not level, if a label contradicts its scale, or if the curves do not end within the
/// picture and within a fifth of the frame's width (upwards: a step of the tick labels) of the frame. The
/// caller checks that the curves could be traced there.
std::optional<LocatedGraph> widenedToItsCurves(const LocatedGraph& graph,
                                               const std::vector<CurveTrace>& curves);

}  // namespace detent::importer
