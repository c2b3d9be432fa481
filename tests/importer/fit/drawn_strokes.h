// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Strokes with known truth for the fit's tests: knots, dense points along them, pixel-like noise.

#include <cmath>
#include <random>
#include <vector>

#include "importer/fit/fit_stroke.h"
#include "model/stroke_curve.h"

namespace detent::importer::drawn {

inline StrokeCurve curveOf(const std::vector<Knot>& knots) { return StrokeCurve::fromKnots(knots).value(); }

/// A tactile key: rise, smooth peak at 1.2 mm, valley at 2.0 mm, slope, vertical rise. 5 pieces.
inline StrokeCurve tactileKey() {
  return curveOf({{0, 0.3, 0.25, 0.25},
                  {1.2, 0.55, 0, 0},
                  {2.0, 0.38, 0, 0},
                  {3.6, 0.62, 0.1, 0.1},
                  {3.8, 0.65, 0.2, 0},
                  {3.8, 1.2, 0, 0}});
}

/// Points every `step_px` of arc length in a picture of width_px x height_px that the curve fills.
inline std::vector<CurvePoint> traced(const StrokeCurve& curve, double width_px, double height_px,
                                      double noise_px, unsigned seed = 1, double step_px = 1) {
  const auto [least, most] = curve.forceRange_N();
  const double mmPerPx = curve.travel_mm() / width_px,
               newtonPerPx = most > least ? (most - least) / height_px : 1;
  std::vector<CurvePoint> fine;
  const std::vector<Knot>& knots = curve.knots();
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double h = knots[k + 1].displacement_mm - knots[k].displacement_mm,
                 d = knots[k + 1].force_N - knots[k].force_N;
    const double a = h > 0 ? knots[k].slopeAfter_N_per_mm * h : d,
                 b = h > 0 ? knots[k + 1].slopeBefore_N_per_mm * h : d;
    for (int i = 0; i < 2000; ++i) {
      const double t = i / 2000.0;
      fine.push_back({knots[k].displacement_mm + h * t,
                      knots[k].force_N + t * (a + t * ((3 * d - 2 * a - b) + t * (a + b - 2 * d)))});
    }
  }
  fine.push_back({knots.back().displacement_mm, knots.back().force_N});
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, noise_px);
  std::vector<CurvePoint> points;
  double arc = 0, next = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const CurvePoint& before = fine[i > 0 ? i - 1 : 0];
    arc += std::hypot((fine[i].displacement_mm - before.displacement_mm) / mmPerPx,
                      (fine[i].force_N - before.force_N) / newtonPerPx);
    if (arc + 1e-9 < next && i + 1 < fine.size()) continue;
    next = arc + step_px;
    points.push_back(
        {fine[i].displacement_mm + noise(random) * mmPerPx, fine[i].force_N + noise(random) * newtonPerPx});
  }
  return points;
}

inline FitOptions optionsFor(const StrokeCurve& curve, double width_px, double height_px, double noise_px) {
  const auto [least, most] = curve.forceRange_N();
  FitOptions options;
  options.noise = {noise_px * curve.travel_mm() / width_px,
                   noise_px * std::max(most - least, 1e-12) / height_px};
  return options;
}

inline std::vector<CurvePoint> reversed(std::vector<CurvePoint> points) {
  return {points.rbegin(), points.rend()};
}

/// Greatest difference in force between two curves, outside of 1 % of travel around their vertical rises.
inline double worstForceError(const StrokeCurve& fit, const StrokeCurve& truth, double until_mm) {
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = truth.start_mm() + (until_mm - truth.start_mm()) * i / 1000.0;
    worst = std::max(worst, std::abs(fit.force_N(x) - truth.force_N(x)));
  }
  return worst;
}

/// Is every piece monotone (no extremum strictly inside a piece)?
inline bool piecesAreMonotone(const StrokeCurve& curve) {
  const std::vector<Knot>& knots = curve.knots();
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double h = knots[k + 1].displacement_mm - knots[k].displacement_mm,
                 d = knots[k + 1].force_N - knots[k].force_N;
    const double a = knots[k].slopeAfter_N_per_mm * h, b = knots[k + 1].slopeBefore_N_per_mm * h;
    if (h == 0) continue;
    for (int i = 0; i <= 50; ++i) {
      const double t = i / 50.0, slope = a + t * (2 * (3 * d - 2 * a - b) + 3 * t * (a + b - 2 * d));
      if (slope * d < -1e-9 * d * d) return false;
    }
  }
  return true;
}

}  // namespace detent::importer::drawn
