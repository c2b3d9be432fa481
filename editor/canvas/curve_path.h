// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke as screen polylines: what the screen can show of it, and no more.

#include <QPolygonF>
#include <vector>

#include "editor/canvas/plot_mapping.h"
#include "model/stroke_curve.h"

namespace detent::editor {

/// How far from the visible part points may lie before they are left out.
inline constexpr double offscreenMargin_px = 64;

/// The part of a curve that may be seen, cut into polylines that leave the visible part nowhere. Straight
/// lines between their points stay within `tolerance_px` (> 0) of the curve. Cost: knots and pixels shown.
std::vector<QPolygonF> curvePolylines(const StrokeCurve& curve, const PlotMapping& map,
                                      double tolerance_px = 0.1);

/// The same for points joined by straight lines (damping, traced points), plot coordinates.
std::vector<QPolygonF> clippedPolylines(const QPolygonF& points_px, const QRectF& clip_px);

/// Points of a curve for filling: from_mm to to_mm, ends included, inside the visible displacements.
/// Forces far outside the visible part are pulled to its margin.
QPolygonF curveOutline(const StrokeCurve& curve, double from_mm, double to_mm, const PlotMapping& map,
                       double tolerance_px = 0.25);

}  // namespace detent::editor
