// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/feel_distance.h"

#include <algorithm>
#include <cmath>

#include "model/units.h"

namespace detent::importer {
namespace {

/// Slopes beyond are of walls and edges, where a hundredth of a millimetre decides.
constexpr double steepest_gf_per_mm = 60;

/// Displacements compared: 0.04 mm apart on a key switch, below which slopes are of the meters' noise.
constexpr std::size_t comparedAt = 100;

/// Force of a shape at a displacement from contact, linear in between, its ends beyond them.
double forceAt_N(const std::vector<float>& forces, double step_mm, double displacement_mm) {
  const double at = std::clamp(displacement_mm / step_mm, 0.0, static_cast<double>(forces.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(at), forces.size() - 2);
  const double share = at - static_cast<double>(i);
  return (1 - share) * double{forces[i]} + share * double{forces[i + 1]};
}

double stepOf(const FeltShape& shape) { return shape.travel_mm / double(FeltShape::samples - 1); }

/// Mean squares of what differs, in gf and gf/mm.
struct Differences {
  double force_gf2 = 0, slope_gf2_per_mm2 = 0;
};

Differences differences(const FeltShape& a, const std::vector<float>& ofA, const FeltShape& b,
                        const std::vector<float>& ofB) {
  const double gf_per_N = 1 / newtonsPer(ForceUnit::gramForce);
  const double both_mm = std::min(a.travel_mm, b.travel_mm);
  constexpr std::size_t count = comparedAt;
  const double step_mm = both_mm / double(count - 1);
  const auto slope = [&](double from_N, double to_N) {
    return std::clamp((to_N - from_N) * gf_per_N / step_mm, -steepest_gf_per_mm, steepest_gf_per_mm);
  };
  Differences sum;
  double lastA_N = 0, lastB_N = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x_mm = step_mm * static_cast<double>(i);
    const double a_N = forceAt_N(ofA, stepOf(a), x_mm), b_N = forceAt_N(ofB, stepOf(b), x_mm);
    sum.force_gf2 += (a_N - b_N) * (a_N - b_N) * gf_per_N * gf_per_N;
    if (i > 0) {
      const double apart = slope(lastA_N, a_N) - slope(lastB_N, b_N);
      sum.slope_gf2_per_mm2 += apart * apart;
    }
    lastA_N = a_N, lastB_N = b_N;
  }
  return {sum.force_gf2 / double(count), sum.slope_gf2_per_mm2 / double(count - 1)};
}

}  // namespace

FeelDistance::FeelDistance(const FeltShape& wanted, const FeelWeights& weights)
    : wanted_(wanted), weights_(weights) {}

double FeelDistance::to(const FeltShape& other) const {
  const Differences press = differences(wanted_, wanted_.press_N, other, other.press_N);
  double sum = press.force_gf2 + weights_.slope_mm * weights_.slope_mm * press.slope_gf2_per_mm2;
  // A record without its way up is compared by its way down alone, which has then to speak for both.
  const bool releases = !wanted_.release_N.empty() && !other.release_N.empty();
  const double release_gf2 =
      releases ? differences(wanted_, wanted_.release_N, other, other.release_N).force_gf2 : press.force_gf2;
  sum += weights_.release * weights_.release * release_gf2;
  const double travel_gf = weights_.travel_gf_per_mm * (wanted_.travel_mm - other.travel_mm);
  return std::sqrt(sum + travel_gf * travel_gf) / labNoise_gf;
}

}  // namespace detent::importer
