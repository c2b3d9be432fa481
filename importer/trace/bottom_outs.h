// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Bottom-outs that were lost because they stand on a line of the plot: on a gridline, on the frame's edge, or
// drawn as a separate path. Private to importer/trace.

#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Extends every curve that ends at a bottom-out by it. A gridline is as thick above the curve's end as below
/// it; a bottom-out holds about as many of the curve's pixels as the curve does.
void addLostBottomOuts(std::vector<CurveTrace>& traces, const PlotScene& scene);

}  // namespace detent::importer::trace
