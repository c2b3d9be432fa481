// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Press and release drawn in one ink: a hysteresis loop that touches and crosses itself, under grid, leaders
// and text of the same ink. Both strokes are followed at once, globally.

#include "importer/page/progress.h"
#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// `ink`: coverage of the area by the curves' ink, grid, frame and text of the same ink still in it. Gives one
/// trace (press only) or two, each with its `stroke`. Failure noForceGraph / notCertain as traceCurves.
Result<std::vector<CurveTrace>> traceLoop(const PlotArea& area, const Plane& ink, Rgb color,
                                          const TraceOptions& options = {}, const Progress& progress = {});

}  // namespace detent::importer::trace
