// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How far apart two force graphs lie: the same figures for two buttons, two files, a fit and its points.

#include <optional>
#include <vector>

#include "model/force_graph.h"

namespace detent {

/// A stroke as a polyline in the order travelled.
using StrokePolyline = std::vector<CurvePoint>;

/// Both strokes of one graph; an empty one is not known.
struct GraphPolylines {
  StrokePolyline press, release;
};
GraphPolylines polylinesOf(const ForceGraph& graph);

/// Distance between two polylines. Normalised: displacement and force are divided by the spans (max - min) of
/// the first graph over both strokes; each sample (every 0.002 of arc length, at most 100,000 a stroke) is paired with the nearest
/// place of the other.
struct StrokeDistance {
  double meanOfSpan = 0;           ///< symmetric: mean of the two one-sided means
  double p95OfSpan = 0;            ///< larger of the two one-sided 95th percentiles
  double maxOfSpan = 0;            ///< larger of the two one-sided maxima (Hausdorff)
  double mean_mm = 0, max_mm = 0;  ///< the displacement part of the same pairs
  double mean_N = 0, max_N = 0;    ///< their force part
};

struct GraphDistance {
  double span_mm = 0, span_N = 0;                ///< of the first graph
  std::optional<StrokeDistance> press, release;  ///< strokes both graphs have
  double meanOfSpan = 0;                         ///< mean over these strokes
  double maxOfSpan = 0;
};

/// Failure wrongUsage if the graphs have no stroke in common. Symmetric up to the choice of the spans. Any
/// thread.
Result<GraphDistance> compare(const GraphPolylines& first, const GraphPolylines& second);

}  // namespace detent
