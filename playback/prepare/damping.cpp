// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/damping.h"

#include <algorithm>

namespace detent::playback {

namespace {

// Largest b (T + delay) / m. At 1 a sampled damper oscillates by itself; a quarter leaves room for the
// estimate of velocity.
constexpr double dampingOfMass = 0.25;

}  // namespace

double leastDamping(const std::vector<DampingPoint>& points) {
  if (points.empty()) return 0;
  return std::min_element(points.begin(), points.end(),
                          [](const DampingPoint& a, const DampingPoint& b) {
                            return a.damping_Ns_per_mm < b.damping_Ns_per_mm;
                          })
      ->damping_Ns_per_mm;
}

double raiseDamping(std::vector<DampingPoint>& points, double least_Ns_per_mm, double travel_mm) {
  if (points.empty()) {
    points = {{0, least_Ns_per_mm}, {travel_mm, least_Ns_per_mm}};
    return least_Ns_per_mm;
  }
  double added = 0;
  for (DampingPoint& p : points) {
    added = std::max(added, least_Ns_per_mm - p.damping_Ns_per_mm);
    p.damping_Ns_per_mm = std::max(p.damping_Ns_per_mm, least_Ns_per_mm);
  }
  return added;
}

double largestDamping_Ns_per_mm(const ForceDeviceProfile& device, double rate_Hz) {
  constexpr double mPerMm = 1e-3;
  return dampingOfMass * device.mass_kg * mPerMm / (1 / rate_Hz + device.late_s());
}

}  // namespace detent::playback
