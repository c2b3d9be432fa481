// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Removes ends of strokes that were traced along an edge of the frame. Private to importer/trace.

#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Cuts traces where they cross bare paper to the frame's upper or right edge and then run along it.
void cutAcrossToEdges(std::vector<CurveTrace>& traces, const PlotScene& scene);

/// Removes points from a trace's left or right end.
void dropEnd(CurveTrace& trace, std::size_t count, bool atRight);

}  // namespace detent::importer::trace
