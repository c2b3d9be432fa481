// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Bottom-outs on a line of the plot, or drawn as a separate path: which of the pixels above a curve's end are
// the stroke's, the plot's own line or another stroke's. Private to importer/trace.

#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Extends every curve that ends at a bottom-out by it, and cuts a release that was led along the bottom-out
/// of a press in another colour. A gridline is as thick above the curve's end as below it; a bottom-out is
/// nearer to the curve's thickness, and in its colour.
void addLostBottomOuts(std::vector<CurveTrace>& traces, const PlotScene& scene);

/// A line in a curve's colour above its end that may be its bottom-out: too thin, pale or short to be taken.
struct UnprovenBottomOut {
  Point from, to;           ///< area px, upwards
  double thickness_px = 0;  ///< beyond that of the plot's own line there
};

std::vector<UnprovenBottomOut> unprovenBottomOuts(const std::vector<CurveTrace>& traces,
                                                  const PlotScene& scene);

}  // namespace detent::importer::trace
