// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Between curves and dense points, both ways, within a stated tolerance.

#include <optional>
#include <vector>

#include "model/force_graph.h"

namespace detent {

/// Share of the force range (of the whole graph) by which linear interpolation between samples may miss the
/// curve, and by which a curve through dense points may miss a point: below a pixel of any plot that fits a
/// screen.
constexpr double samplingTolerance = 1e-4;

/// Points on the curve by increasing displacement such that straight lines between them stay within
/// `tolerance_N` (> 0) of it. Knots (walls, corners) and extrema are among them exactly.
std::vector<CurvePoint> samplesOf(const StrokeCurve& curve, double tolerance_N);

/// samplesOf with samplingTolerance of the graph's force range, in the order travelled (release: backwards).
std::vector<CurvePoint> travelledSamples(const ForceGraph& graph, Stroke stroke);

/// A curve with few knots, chosen among dense points: it passes every point within `tolerance_N` (> 0) and,
/// between points, stays within twice that of the straight line joining them, so nothing is invented where
/// points are sparse. No noise is modelled and nothing is fitted in displacement: for measured points use the
/// importer's fit. Points by increasing displacement; a run at one displacement is a wall (its inner points
/// must lie between its ends). Failure names the point (counted from 1) that breaks a rule, see faultOf.
Result<StrokeCurve> curveThroughDensePoints(const std::vector<CurvePoint>& points, double tolerance_N);

/// What keeps points from being a curve, and which of them it is, from 0.
struct PointFault {
  std::size_t index = 0;
  Message problem;
  Remedies remedies;
};

/// The first rule of curveThroughDensePoints that the points break by themselves; nothing if they keep all.
std::optional<PointFault> faultOf(const std::vector<CurvePoint>& points);

}  // namespace detent
