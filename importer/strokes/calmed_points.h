// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A stroke's points without single outliers.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "model/stroke_curve.h"

namespace detent::importer {

/// Each point as the median of it and its two neighbours, in displacement and in force; an end as the point
/// beside it. Fewer than three are left as they are. For judging a whole (extent, sign, direction), not for
/// tracing: a bottom-out's only sample goes, too.
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
