// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/spring_button.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace detent::playback {

namespace {

constexpr std::size_t mostCoefficients = 12;
constexpr int springKnots = 64;  // knots of the force, with exact slopes, and points of the damping

double valueAt(const std::vector<double>& coefficients, double x) {
  double value = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) value = value * x + *c;
  return value;
}

/// Slope of k(x) x.
double slopeAt(const std::vector<double>& stiffness, double x) {
  double slope = 0;
  for (std::size_t i = stiffness.size(); i > 0; --i)
    slope = slope * x + static_cast<double>(i) * stiffness[i - 1];
  return slope;
}

Failure refused(const std::string& subject, const std::string& problem) {
  return {FailureCode::wrongUsage, subject, "", problem,
          "Give up to 12 coefficients of x^0, x^1, ... with x in mm, and a travel above 0 mm"};
}

}  // namespace

Result<Button> springButton(const std::string& name, const SpringPolynomials& spring) {
  const auto& k = spring.stiffness_N_per_mm;
  const auto& b = spring.damping_Ns_per_mm;
  if (k.empty() || k.size() > mostCoefficients)
    return refused("stiffness", "has " + std::to_string(k.size()) + " coefficients");
  if (b.size() > mostCoefficients)
    return refused("damping", "has " + std::to_string(b.size()) + " coefficients");
  if (!(spring.travel_mm > 0) || !std::isfinite(spring.travel_mm)) return refused("travel", "is no length");
  std::vector<Knot> knots;
  std::vector<DampingPoint> damping;
  for (int i = 0; i <= springKnots; ++i) {
    const double x_mm = spring.travel_mm * i / springKnots, slope = slopeAt(k, x_mm);
    knots.push_back({x_mm, valueAt(k, x_mm) * x_mm, slope, slope});
    if (!b.empty()) damping.push_back({x_mm, valueAt(b, x_mm)});
  }
  const auto negative = std::find_if(damping.begin(), damping.end(),
                                     [](const DampingPoint& d) { return !(d.damping_Ns_per_mm >= 0); });
  if (negative != damping.end())
    return refused("damping", "is not above 0 at " + std::to_string(negative->displacement_mm) + " mm");
  Result<StrokeCurve> curve = StrokeCurve::fromKnots(std::move(knots));
  if (!curve) return curve.failure();
  Result<ForceGraph> graph = ForceGraph::fromCurves(*curve, *curve);
  if (!graph) return graph.failure();
  return Button::fromStates(name, {{"", *std::move(graph), {}, {}, std::move(damping)}});
}

}  // namespace detent::playback
