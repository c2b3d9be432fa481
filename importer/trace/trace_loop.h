// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Press and release drawn in one ink: a hysteresis loop that touches and crosses itself, under grid, leaders
// and text of the same ink. Both strokes are followed at once, globally.

#include "importer/trace/curve_trace.h"
#include "importer/trace/ink_layer.h"

namespace detent::importer {

/// Gives one trace (press only) or two, each with its `stroke`. Failure noForceGraph / notCertain as
/// traceCurves.
Result<std::vector<CurveTrace>> traceLoop(const InkLayer& ink, const PlotFrame& frame, const AxesFound& axes,
                                          const TraceHints& hints = {}, const TraceOptions& options = {},
                                          const Progress& progress = {});

}  // namespace detent::importer
