// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Conversion between curves and dense points within a tolerance.

#include <optional>
#include <vector>

#include "model/force_graph.h"

namespace detent {

/// Largest error as a share of the graph's force range, of linear interpolation between samples and of a
/// curve through dense points. Below one pixel of any plot that fits a screen.
constexpr double samplingTolerance = 1e-4;

/// Returns points by increasing displacement such that straight lines between them stay within `tolerance_N`
/// (> 0) of the curve. Knots and extrema are included exactly.
std::vector<CurvePoint> samplesOf(const StrokeCurve& curve, double tolerance_N);

/// samplesOf with samplingTolerance of the graph's force range, in the order travelled (release: backwards).
std::vector<CurvePoint> travelledSamples(const ForceGraph& graph, Stroke stroke);

/// Returns a curve with few knots among dense points. It passes every point within `tolerance_N` (> 0) and
/// stays within twice that of the line between points, so nothing is invented between sparse points. It
/// models no noise: for measured points use the importer's fit. Points by increasing displacement; several
/// points at one displacement are a vertical piece, inner ones between its ends. The Failure names the point
/// (from 1) that breaks a rule, see faultOf.
Result<StrokeCurve> curveThroughDensePoints(const std::vector<CurvePoint>& points, double tolerance_N);

/// The reason why points are no curve, and the index of the offending point, from 0.
struct PointFault {
  std::size_t index = 0;
  Message problem;
  Remedies remedies;
};

/// Returns the first rule of curveThroughDensePoints that the points break; nullopt if none.
std::optional<PointFault> faultOf(const std::vector<CurvePoint>& points);

}  // namespace detent
