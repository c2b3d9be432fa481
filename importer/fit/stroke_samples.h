// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Points of one stroke prepared for the fit: ordered by displacement, thinned, in units of their noise.

#include <vector>

#include "importer/fit/fit_options.h"
#include "model/sections.h"
#include "model/stroke_curve.h"

namespace detent::importer {

/// One point in sigmas: u along displacement, v along force, origin at the stroke's first point.
struct SigmaPoint {
  double u = 0, v = 0;
  double weight = 1;  ///< 1/sigma in these units; > 1 for averages and near tactile points
};

/// Points of a stroke and the conversion back to mm and N.
struct StrokeSamples {
  std::vector<SigmaPoint> points;  ///< >= 2, by increasing displacement; neighbours differ
  CurvePoint origin;               ///< origin of u and v, in mm and N
  double mmPerU = 1, newtonsPerV = 1;

  double u(double displacement_mm) const { return (displacement_mm - origin.displacement_mm) / mmPerU; }
  double v(double force_N) const { return (force_N - origin.force_N) / newtonsPerV; }
  double displacement_mm(double u) const { return origin.displacement_mm + u * mmPerU; }
  double force_N(double v) const { return origin.force_N + v * newtonsPerV; }
};

/// Checks, orders and thins points. Leaves out single points far outside all others, or more than 20 sigmas
/// off the line of their four neighbours. First and last point stay; if there are more than
/// `options.maxPoints`, points between are averaged over equal arc lengths. Failures: as of fitStroke.
Result<StrokeSamples> prepareSamples(const std::vector<CurvePoint>& points, Stroke stroke,
                                     const FitOptions& options);

}  // namespace detent::importer
