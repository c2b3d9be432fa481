// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The bottom-out wall of a stroke that was lost because it stands on a line of the plot: on a gridline, on the frame's
// edge, or drawn as a path of its own. Private to importer/trace.

#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Lengthens every curve that ends at the foot of a wall by that wall. A gridline is as thick above the curve's end as
/// below it; from the foot of a wall upwards the lane holds about as much of the curve's ink as the curve does.
void addLostWalls(std::vector<CurveTrace>& traces, const PlotScene& scene);

}  // namespace detent::importer::trace
