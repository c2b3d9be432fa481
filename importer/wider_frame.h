// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A plot may go on beyond the last gridline that has a number, and its curves with it: the frame is widened
// to where they end. Any thread.

#include <optional>
#include <vector>

#include "importer/locate_graphs.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Whether ink of this colour stands on a straight line beyond a curve's end, seen at three places.
bool goesOnBeyond(const std::vector<Point>& curve, Rgb color, const Raster& picture);

/// The graph with its right and upper edges where the ink of its curves ends, and the scales drawn on to
/// there. Empty where no curve leaves the frame there, where the frame does not stand level or a label
/// contradicts its scale, and where the ink does not end within the picture and a fifth of the frame's width
/// or a step of the axis' numbers (upwards such a step, or up to the last number of the axis, to which the
/// frame goes in any case). Whether the curves could be followed there is the caller's question.
std::optional<LocatedGraph> widenedToItsCurves(const LocatedGraph& graph,
                                               const std::vector<CurveTrace>& curves);

}  // namespace detent::importer
