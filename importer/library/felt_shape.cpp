// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/felt_shape.h"

#include <algorithm>

#include "model/sections.h"
#include "model/units.h"

namespace detent::importer {
namespace {

/// Above the force that meters show in the air, and below the first resistance of a switch.
constexpr double contact_gf = 5;

/// Displacement at which the press first resists; the start of a curve that begins in contact.
double contactOf(const StrokeCurve& press, double bottom_mm) {
  const auto [least_N, most_N] = press.forceRange_N();
  // For a button softer than a key switch, the same share of its force: 5 gf of 50.
  const double bar_N = std::min(contact_gf * newtonsPer(ForceUnit::gramForce), 0.1 * std::max(most_N, 0.0));
  if (press.force_N(press.start_mm()) >= bar_N) return press.start_mm();
  const std::vector<double> at = press.displacementsAt(bar_N);
  return at.empty() || at.front() >= bottom_mm ? press.start_mm() : at.front();
}

std::vector<float> sampled(const StrokeCurve& curve, double from_mm, double travel_mm) {
  std::vector<float> forces(FeltShape::samples);
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] = static_cast<float>(
        curve.force_N(from_mm + travel_mm * static_cast<double>(i) / double(FeltShape::samples - 1)));
  return forces;
}

}  // namespace

std::optional<FeltShape> feltShapeOf(const ForceGraph& graph) {
  const StrokeCurve& press = graph.press();
  const double bottom_mm = bottomOutOf(press).displacement_mm;
  const double from_mm = contactOf(press, bottom_mm);
  FeltShape shape;
  shape.travel_mm = bottom_mm - from_mm;
  if (!(shape.travel_mm > 0)) return {};
  shape.press_N = sampled(press, from_mm, shape.travel_mm);
  if (graph.release()) shape.release_N = sampled(*graph.release(), from_mm, shape.travel_mm);
  return shape;
}

}  // namespace detent::importer
