// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A plot may go on beyond the last gridline that has a number, and its curves with it: the frame is widened
// to where they end. Any thread.

#include <optional>
#include <vector>

#include "importer/locate_graphs.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Returns true if pixels of this colour are on a straight line beyond a curve's end, seen at three
/// positions.
bool goesOnBeyond(const std::vector<Point>& curve, Rgb color, const Raster& picture);

/// The graph with its right and upper edges moved to the ends of its curves' pixels, and the scales extended
/// to there. Empty if no curve leaves the frame there, if the frame is not level or a label contradicts its
/// scale, and if the pixels do not end within the picture and a fifth of the frame's width or a step of the
/// tick labels (upwards such a step, or up to the last tick label, to which the frame goes in any case). The
/// caller checks that the curves could be followed there.
std::optional<LocatedGraph> widenedToItsCurves(const LocatedGraph& graph,
                                               const std::vector<CurveTrace>& curves);

}  // namespace detent::importer
