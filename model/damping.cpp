// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/damping.h"

#include <algorithm>

namespace detent {

double dampingAt(const std::vector<DampingPoint>& points, double displacement_mm) {
  if (points.empty()) return 0;
  const auto above = std::ranges::upper_bound(points, displacement_mm, {}, &DampingPoint::displacement_mm);
  if (above == points.begin()) return points.front().damping_Ns_per_mm;
  if (above == points.end()) return points.back().damping_Ns_per_mm;
  const DampingPoint &a = *(above - 1), &b = *above;
  const double share = (displacement_mm - a.displacement_mm) / (b.displacement_mm - a.displacement_mm);
  return a.damping_Ns_per_mm + share * (b.damping_Ns_per_mm - a.damping_Ns_per_mm);
}

}  // namespace detent
