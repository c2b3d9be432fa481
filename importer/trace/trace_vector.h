// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Curves that the document carries as paths: taken as they are, exact.

#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// Empty if the curves are not among the view's paths, or only parts of them (then the raster is traced;
/// docs/develop/decisions/0303-curves-from-vector-paths.md). Grid, frame, leaders,
/// arrows, glyph outlines, legend samples and markers are told from curves. Where both strokes share one ink,
/// `stroke` is set.
std::vector<CurveTrace> traceVector(const PageView& view, const PlotFrame& frame, const AxesFound& axes,
                                    const TraceHints& hints = {});

}  // namespace detent::importer
