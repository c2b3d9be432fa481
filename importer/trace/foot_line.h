// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The end of a stroke that was followed along the plot's own foot line: a key that stays down gives no force any more, and
// its release ends on the axis in the middle of the travel. Private to importer/trace.

#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Cuts traces where they run along the foot line and it is no thicker there than where no curve comes near it. A line as
/// thick as the curves tells nothing, and nothing is cut.
void cutAlongFootLine(std::vector<CurveTrace>& traces, const PlotScene& scene);

/// Cuts traces where their ink ends and they cross bare paper to the frame's upper or right line, which they run along from there.
void cutAcrossToEdges(std::vector<CurveTrace>& traces, const PlotScene& scene);

/// Takes points off a trace's left or right end.
void dropEnd(CurveTrace& trace, std::size_t count, bool atRight);

}  // namespace detent::importer::trace
