// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ends of strokes that were followed along the x axis: a key that stays down has no force any more, and its
// release ends on the axis in the middle of the travel. Private to importer/trace.

#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Cuts traces where they run along the x axis and the axis is no thicker there than where no curve comes
/// near. If the axis is as thick as the curves, nothing is cut.
void cutAlongAxisLine(std::vector<CurveTrace>& traces, const PlotScene& scene);

/// Cuts traces where they cross bare paper to the frame's upper or right edge and then run along it.
void cutAcrossToEdges(std::vector<CurveTrace>& traces, const PlotScene& scene);

/// Removes points from a trace's left or right end.
void dropEnd(CurveTrace& trace, std::size_t count, bool atRight);

}  // namespace detent::importer::trace
