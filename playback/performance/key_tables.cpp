// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/key_tables.h"

#include <algorithm>

#include "model/damping.h"

namespace detent::playback {

namespace {

constexpr double steepest_N_per_m =
    200000;  // slope of a graph's vertical rise; steeper ones would need a step below 50 µs
constexpr double ownDamping_Ns_per_m = 0.2;  // damping of every key cap itself
constexpr double tableMetre_mm = 1000;

/// Limits slopes to what the step can follow; the force at the start is kept.
void limitSlope(std::vector<double>& values_N, double most_N) {
  for (std::size_t i = 1; i < values_N.size(); ++i)
    values_N[i] = std::clamp(values_N[i], values_N[i - 1] - most_N, values_N[i - 1] + most_N);
}

}  // namespace

KeyTables::KeyTables(const ButtonState& state)
    : end_m_(state.graph.travel_mm() / tableMetre_mm), cell_m_(end_m_ / cells) {
  const StrokeCurve& press = state.graph.press();
  const StrokeCurve& release = state.graph.curve(Stroke::release);
  std::vector<double> down_N, up_N, damping;
  for (int i = 0; i <= cells; ++i) {
    const double depth_mm = state.graph.travel_mm() * i / cells;
    down_N.push_back(press.force_N(depth_mm));
    up_N.push_back(release.force_N(depth_mm));
    damping.push_back(ownDamping_Ns_per_m + tableMetre_mm * dampingAt(state.damping, depth_mm));
  }
  limitSlope(down_N, steepest_N_per_m * cell_m_);
  limitSlope(up_N, steepest_N_per_m * cell_m_);
  double stored_J = 0;
  for (std::size_t i = 0; i < down_N.size(); ++i) {
    // At crossings of the strokes the release is set to the press, because a button cannot supply energy.
    const double back_N = std::min(down_N[i], up_N[i]);
    const double mean_N = 0.5 * (down_N[i] + back_N);
    if (i > 0) stored_J += 0.5 * (mean_N + cells_.back().mean_N) * cell_m_;
    evenDamping_ = evenDamping_ && damping[i] == damping.front();
    cells_.push_back({mean_N, 0.5 * (down_N[i] - back_N), damping[i], stored_J});
  }
}

}  // namespace detent::playback
