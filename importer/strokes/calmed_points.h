// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Removes single outliers from a stroke's points.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "model/stroke_curve.h"

namespace detent::importer {

/// Each point is replaced by the median of itself and its two neighbours, in displacement and in force; an
/// end by its neighbour. Fewer than three points stay unchanged. For judging the whole stroke (extent, sign,
/// direction), not for tracing, because it may remove the only sample of a bottom-out.
inline std::vector<CurvePoint> calmed(const std::vector<CurvePoint>& points) {
  if (points.size() < 3) return points;
  const auto middle = [](double a, double b, double c) {
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
  };
  std::vector<CurvePoint> calm;
  calm.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t at = std::clamp<std::size_t>(i, 1, points.size() - 2);
    const CurvePoint &a = points[at - 1], &b = points[at], &c = points[at + 1];
    calm.push_back({middle(a.displacement_mm, b.displacement_mm, c.displacement_mm),
                    middle(a.force_N, b.force_N, c.force_N)});
  }
  return calm;
}

}  // namespace detent::importer
