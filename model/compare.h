// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Distance between two force graphs: of two buttons, two files, or a fit and its points.

#include <limits>
#include <optional>
#include <vector>

#include "model/force_graph.h"

namespace detent {

/// A stroke as a polyline in the order travelled.
using StrokePolyline = std::vector<CurvePoint>;

/// Both strokes of one graph; an empty stroke is unknown.
struct GraphPolylines {
  StrokePolyline press, release;
  /// Displacement where each stroke's steep bottom-out begins; infinity if it has none or is unknown.
  double pressBottomOut_mm = std::numeric_limits<double>::infinity();
  double releaseBottomOut_mm = std::numeric_limits<double>::infinity();
};
GraphPolylines polylinesOf(const ForceGraph& graph);

/// Distance between two polylines. For the normalised distances, displacement and force are divided by the
/// spans (max - min) of the first graph over both strokes. Each sample (every 0.002 of arc length, at most
/// 100,000 per stroke) is paired with the nearest place on the other polyline.
struct StrokeDistance {
  double meanOfSpan = 0;  ///< symmetric: mean of the two one-sided means
  double p95OfSpan = 0;   ///< larger of the two one-sided 95th percentiles
  double maxOfSpan = 0;   ///< larger of the two one-sided maxima (Hausdorff)
  /// The same of the samples before the bottom-out that begins first; maxOfSpan without a steep bottom-out.
  double maxBeforeBottomOutOfSpan = 0;
  double mean_mm = 0, max_mm = 0;  ///< displacement part of the same pairs
  double mean_N = 0, max_N = 0;    ///< force part of the same pairs
};

struct GraphDistance {
  double span_mm = 0, span_N = 0;                ///< spans of the first graph
  std::optional<StrokeDistance> press, release;  ///< strokes that both graphs have
  double meanOfSpan = 0;                         ///< mean over the strokes that both graphs have
  double maxOfSpan = 0;
};

/// Failure wrongUsage if the graphs have no stroke in common. Symmetric except for the choice of the spans.
/// Any thread.
Result<GraphDistance> compare(const GraphPolylines& first, const GraphPolylines& second);

}  // namespace detent
