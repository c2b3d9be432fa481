// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Polylines in any plane, with the operations that all steps share.

#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

using Polyline = std::vector<Point>;

/// The box around the points; at least one.
Box boundsOf(const Polyline& points);

double lengthOf(const Polyline& line);

/// Length from the first point to each.
std::vector<double> arcOf(const Polyline& line);

/// Position on segment a-b that is nearest to p, 0 (at a) .. 1 (at b).
double projectionOn(Point a, Point b, Point p);

/// The point of the line nearest to p; the line has at least one.
Point nearestOn(const Polyline& line, Point p);

/// Twice the enclosed area of the closed line; positive if it runs clockwise (y down).
double twiceAreaOf(const Polyline& ring);

/// The line without repeated points.
Polyline withoutRepeats(const Polyline& line);

/// The points of the line and as many between them that no two are farther apart than `step`.
Polyline densified(const Polyline& line, double step);

/// Points about `spacing` apart along the line; its ends are kept.
Polyline resampled(const Polyline& line, double spacing);

/// Gaussian along the line, `sigma` in points; the window shrinks towards the ends, which stay.
Polyline smoothed(const Polyline& line, double sigma);

/// Unit normals to the left of travel (up for a line that runs right, y down), from points up to `reach`
/// before and after.
Polyline normalsOf(const Polyline& line, int reach);

/// The smoothest values near `target`: minimises sum weight (value - target)^2 + stiffness * sum (second
/// difference)^2 (Whittaker 1922), by a banded LDL^T in place.
std::vector<double> stiffened(const std::vector<double>& target, const std::vector<double>& weight,
                              double stiffness);

}  // namespace detent::importer
