// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/fit_strokes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "importer/rest_position.h"

namespace detent::importer {
namespace {

/// The points of a stroke, with intermediate points so that no segment is longer than two pixels. A document
/// stores only the two ends of a straight section, but the fit needs points between them.
std::vector<CurvePoint> withoutGaps(const StrokePoints& stroke) {
  constexpr double longest_px = 2;
  if (!stroke.fromVector || stroke.points_px.size() != stroke.points.size()) return stroke.points;
  std::vector<CurvePoint> dense;
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    if (i > 0) {
      const CurvePoint a = stroke.points[i - 1], b = stroke.points[i];
      const Point p = stroke.points_px[i - 1], q = stroke.points_px[i];
      const int steps = static_cast<int>(std::min(std::hypot(q.x - p.x, q.y - p.y) / longest_px, 1e4));
      for (int k = 1; k < steps; ++k) {
        const double share = double(k) / steps;
        dense.push_back({a.displacement_mm + share * (b.displacement_mm - a.displacement_mm),
                         a.force_N + share * (b.force_N - a.force_N)});
      }
    }
    dense.push_back(stroke.points[i]);
  }
  return dense;
}

Result<FittedStroke> fitAtRest(const std::vector<CurvePoint>& points, Stroke stroke,
                               const FitOptions& options) {
  auto fitted = fitStroke(points, stroke, options);
  if (!fitted) return fitted.failure();
  auto moved = startingAtRest(fitted->curve);
  if (!moved) return moved.failure();
  return FittedStroke{std::move(moved).value(), fitted->summary};
}

}  // namespace

Result<FittedStrokes> fitBoth(const StrokePair& strokes, const FitOptions& press, const FitOptions& release) {
  auto fittedPress = fitAtRest(withoutGaps(strokes.press), Stroke::press, press);
  if (!fittedPress) return fittedPress.failure();
  FittedStrokes fitted{std::move(fittedPress).value(), {}};
  if (strokes.release) {
    auto fittedRelease = fitAtRest(withoutGaps(*strokes.release), Stroke::release, release);
    if (!fittedRelease) return fittedRelease.failure();
    fitted.release = std::move(fittedRelease).value();
  }
  return fitted;
}

}  // namespace detent::importer
