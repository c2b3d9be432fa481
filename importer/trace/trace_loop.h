// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Press and release in one colour: a loop that touches and crosses itself, under grid, leaders and text of
// the same colour. Both strokes are followed together, globally.

#include "importer/page/progress.h"
#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// Input: coverage of the area by the curves' colour, including grid, frame and text of that colour. Returns
/// one trace (press only) or two, each with its `stroke`. Failure noForceGraph / notCertain as traceCurves.
Result<std::vector<CurveTrace>> traceLoop(const PlotArea& area, const Plane& coverage, Rgb color,
                                          const TraceOptions& options = {}, const Progress& progress = {});

}  // namespace detent::importer::trace
