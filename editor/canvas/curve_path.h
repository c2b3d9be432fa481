// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke as screen polylines, limited to what the screen can show.

#include <QPolygonF>
#include <vector>

#include "editor/canvas/plot_mapping.h"
#include "model/stroke_curve.h"

namespace detent::editor {

/// Distance from the visible part beyond which points are left out.
inline constexpr double offscreenMargin_px = 64;

/// The visible part of a curve, cut into polylines that stay inside it. Straight lines between their points
/// are within `tolerance_px` (> 0) of the curve. Cost: number of knots and shown pixels.
std::vector<QPolygonF> curvePolylines(const StrokeCurve& curve, const PlotMapping& map,
                                      double tolerance_px = 0.2);

/// The same for points joined by straight lines (damping, traced points), in plot coordinates.
std::vector<QPolygonF> clippedPolylines(const QPolygonF& points_px, const QRectF& clip_px);

/// Points of a curve for filling: from_mm to to_mm, ends included, inside the visible displacements. Forces
/// far outside the visible part are clamped to its margin.
QPolygonF curveOutline(const StrokeCurve& curve, double from_mm, double to_mm, const PlotMapping& map,
                       double tolerance_px = 0.25);

}  // namespace detent::editor
