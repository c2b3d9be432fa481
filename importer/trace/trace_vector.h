// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Curves from the document's own paths, exact.

#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Empty if the curves are not among the view's paths, or only in part (then pixels are traced;
/// docs/develop/decisions/0303-curves-from-vector-paths.md). Excludes grid, frame, leaders, arrows, glyph
/// outlines, legend keys and markers. If both strokes share one colour, `stroke` is set.
std::vector<CurveTrace> traceVector(const PageView& view, const PlotFrame& frame, const AxesFound& axes,
                                    const TraceHints& hints = {});

}  // namespace detent::importer
