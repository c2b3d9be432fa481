// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/key_tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/damping.h"

namespace detent::playback {

namespace {

constexpr double stop_N_per_m = 20000;  // 20 N/mm, the wall of docs/press-forecast.md
constexpr double steepest_N_per_m =
    200000;  // a vertical wall of a graph; steeper ones would outrun the step of 50 µs
constexpr double ownDamping_Ns_per_m = 0.2;  // of every cap
constexpr double metre_mm = 1000;

/// Cuts what rises or falls faster than the step can follow; the force at the start stays.
void limitSlope(std::vector<double>& values_N, double most_N) {
  for (std::size_t i = 1; i < values_N.size(); ++i)
    values_N[i] = std::clamp(values_N[i], values_N[i - 1] - most_N, values_N[i - 1] + most_N);
}

}  // namespace

KeyTables::KeyTables(const ButtonState& state)
    : end_m_(state.graph.travel_mm() / metre_mm), cell_m_(end_m_ / cells) {
  const StrokeCurve& press = state.graph.press();
  const StrokeCurve& release = state.graph.curve(Stroke::release);
  std::vector<double> down_N, up_N;
  for (int i = 0; i <= cells; ++i) {
    const double depth_mm = state.graph.travel_mm() * i / cells;
    down_N.push_back(press.force_N(depth_mm));
    up_N.push_back(release.force_N(depth_mm));
    damping_.push_back(ownDamping_Ns_per_m + metre_mm * dampingAt(state.damping, depth_mm));
  }
  limitSlope(down_N, steepest_N_per_m * cell_m_);
  limitSlope(up_N, steepest_N_per_m * cell_m_);
  double stored_J = 0;
  for (std::size_t i = 0; i < down_N.size(); ++i) {
    // Where strokes cross, the release counts as the press: a button gives no energy away.
    const double back_N = std::min(down_N[i], up_N[i]);
    mean_N_.push_back(0.5 * (down_N[i] + back_N));
    halfWidth_N_.push_back(0.5 * (down_N[i] - back_N));
    if (i > 0) stored_J += 0.5 * (mean_N_[i] + mean_N_[i - 1]) * cell_m_;
    stored_J_.push_back(stored_J);
  }
}

KeyTables::Place KeyTables::placeOf(double depth_m) const {
  const double place = std::clamp(depth_m / cell_m_, 0.0, static_cast<double>(cells));
  const int cell = std::min(static_cast<int>(place), cells - 1);
  return {cell, place - cell};
}

double KeyTables::at(const std::vector<double>& values, double depth_m) const {
  const Place place = placeOf(depth_m);
  const double* cell = values.data() + place.cell;
  return cell[0] + place.share * (cell[1] - cell[0]);
}

double KeyTables::mean_N(double depth_m) const {
  const double inside_N = at(mean_N_, depth_m);
  if (depth_m < 0) return inside_N + stop_N_per_m * depth_m;
  return depth_m > end_m_ ? inside_N + stop_N_per_m * (depth_m - end_m_) : inside_N;
}

double KeyTables::stored_J(double depth_m) const {
  const double outside_m = depth_m < 0 ? depth_m : std::max(0.0, depth_m - end_m_);
  const Place place = placeOf(depth_m);
  const double* force_N = mean_N_.data() + place.cell;
  const double along_m = place.share * cell_m_;
  const double inside_J = stored_J_[static_cast<std::size_t>(place.cell)] +
                          along_m * (force_N[0] + 0.5 * place.share * (force_N[1] - force_N[0]));
  const double edge_N = depth_m < 0 ? mean_N_.front() : mean_N_.back();
  return inside_J + outside_m * (edge_N + 0.5 * stop_N_per_m * outside_m);
}

double KeyTables::meanBetween_N(double from_m, double to_m) const {
  const auto pieceOf = [&](double depth_m) {
    return depth_m < 0 ? -1 : depth_m > end_m_ ? cells : placeOf(depth_m).cell;
  };
  constexpr double tooClose_m = 1e-12;  // the difference of two energies would be rounding
  if (pieceOf(from_m) == pieceOf(to_m) || std::abs(to_m - from_m) < tooClose_m)
    return 0.5 * (mean_N(from_m) + mean_N(to_m));
  return (stored_J(to_m) - stored_J(from_m)) / (to_m - from_m);
}

double KeyTables::halfWidth_N(double depth_m) const { return at(halfWidth_N_, depth_m); }

double KeyTables::damping_Ns_per_m(double depth_m) const { return at(damping_, depth_m); }

}  // namespace detent::playback
