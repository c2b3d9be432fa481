// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/stability.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/damping.h"
#include "model/sampling.h"
#include "playback/prepare/damping.h"
#include "playback/prepare/loop_limit.h"
#include "playback/prepare/speed_change.h"

namespace detent::playback {

namespace {

constexpr std::size_t travelSamples = 1024;     // along the travel
constexpr double leastAllowed_N_per_mm = 0.01;  // with a lower slope limit nothing could be felt
constexpr double rounding = 1.0001;
constexpr double limitedTo =
    0.95;  // share of the allowed slope: between its points, a curve of few knots is up to 2.2 % steeper

double late_s(const ForceDeviceProfile& device, double rate_Hz) { return 0.5 / rate_Hz + device.late_s(); }

/// Damping that results from the change of force with speed at a displacement, as far as it is rendered.
SpeedDamping renderedAt(const ButtonState& state, const SpeedDamping& rendered, double at_mm) {
  if (state.otherSpeeds.empty()) return {};
  const SpeedDamping drawn = speedDampingAt(state, at_mm);
  return {std::max(drawn.least, rendered.least), std::min(drawn.most, rendered.most)};
}

/// Loop limits for the range of damping along the travel, including that from speeds.
LoopLimits limitsOf(const ButtonState& state, const ForceDeviceProfile& device, double rate_Hz) {
  double most_Ns_per_mm = 0;
  for (const DampingPoint& d : state.damping) most_Ns_per_mm = std::max(most_Ns_per_mm, d.damping_Ns_per_mm);
  double least_Ns_per_mm = leastDamping(state.damping);
  if (!state.otherSpeeds.empty()) {
    const SpeedDamping rendered = renderedSpeedDamping(state, device, rate_Hz);
    SpeedDamping found;
    for (std::size_t i = 0; i < travelSamples; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(travelSamples);
      const SpeedDamping there = renderedAt(state, rendered, share * state.graph.travel_mm());
      found = {std::min(found.least, there.least), std::max(found.most, there.most)};
    }
    least_Ns_per_mm += found.least;
    most_Ns_per_mm += found.most;
  }
  return {device, rate_Hz, least_Ns_per_mm, most_Ns_per_mm};
}

MarginPoint allowedFor(const ForceDeviceProfile& device, double byLoop_N_per_mm) {
  MarginPoint p;
  p.allowed_N_per_mm = byLoop_N_per_mm;
  const double quantisation = heldByFriction * device.friction_N / device.step_mm;
  if (quantisation < p.allowed_N_per_mm)
    p.allowed_N_per_mm = quantisation, p.bound = StabilityBound::quantisation;
  if (device.largestSlope_N_per_mm <= p.allowed_N_per_mm) {
    p.allowed_N_per_mm = device.largestSlope_N_per_mm;
    p.bound = StabilityBound::device;
  }
  return p;
}

/// Slope of a curve around one displacement, including vertical rises; 0 outside the curve.
double slopeOver(const StrokeCurve& curve, double from_mm, double to_mm) {
  const double low_mm = std::max(from_mm, curve.start_mm()), high_mm = std::min(to_mm, curve.end_mm());
  if (low_mm > high_mm) return 0;
  return (curve.force_N(high_mm) - curve.forceBefore_N(low_mm)) / (to_mm - from_mm);
}

class MarginOfState {
 public:
  MarginOfState(const ButtonState& state, const ForceDeviceProfile& device, double rate_Hz)
      : state_(state),
        device_(device),
        limits_(limitsOf(state, device, rate_Hz)),
        rendered_(renderedSpeedDamping(state, device, rate_Hz)) {}

  void add(std::size_t index, StabilityMargin& margin) const {
    std::vector<MarginPoint> points;
    const double spacing_mm = state_.graph.travel_mm() / static_cast<double>(travelSamples);
    bool broken = false;
    for (std::size_t i = 0; i < travelSamples; ++i) {
      const double from_mm = static_cast<double>(i) * spacing_mm;
      double steepest = steepestOf(state_.graph, from_mm, from_mm + spacing_mm);
      for (const SpeedGraph& other : state_.otherSpeeds) {
        const double otherSlope = steepestOf(other.graph, from_mm, from_mm + spacing_mm);
        if (std::abs(otherSlope) > std::abs(steepest)) steepest = otherSlope;
      }
      const double middle_mm = from_mm + spacing_mm / 2;
      MarginPoint p = allowedFor(device_, loopLimitAt(middle_mm));
      p.displacement_mm = middle_mm;
      p.slope_N_per_mm = std::abs(steepest);
      points.push_back(p);
      const bool breaks = p.slope_N_per_mm > p.allowed_N_per_mm * rounding;
      if (breaks && !broken)
        margin.unstable.push_back({index, from_mm, from_mm + spacing_mm, p, steepest < 0});
      if (breaks) extend(margin.unstable.back(), from_mm + spacing_mm, p, steepest < 0);
      broken = breaks;
      if (margin.states.empty() && points.size() == 1) margin.least = p;
      if (p.margin_N_per_mm() < margin.least.margin_N_per_mm()) margin.least = p;
    }
    margin.states.push_back(std::move(points));
  }

 private:
  static double steepestOf(const ForceGraph& graph, double from_mm, double to_mm) {
    const double rise = slopeOver(graph.press(), from_mm, to_mm);
    const double releaseRise = slopeOver(graph.curve(Stroke::release), from_mm, to_mm);
    return std::abs(rise) >= std::abs(releaseRise) ? rise : releaseRise;
  }

  /// Steepest slope at which the force loop is stable, N/mm: the smallest of the limits at rest and at speeds
  /// between those of the graphs, where the dependence on speed damps the handle or drives it.
  double loopLimitAt(double at_mm) const {
    const double damping = state_.damping.empty() ? 0 : dampingAt(state_.damping, at_mm);
    const double still = limits_.at_N_per_mm(damping);
    if (state_.otherSpeeds.empty()) return still;
    const SpeedDamping change = renderedAt(state_, rendered_, at_mm);
    return std::min(
        {still, limits_.at_N_per_mm(damping + change.least), limits_.at_N_per_mm(damping + change.most)});
  }

  static void extend(UnstableStretch& stretch, double to_mm, const MarginPoint& p, bool falling) {
    stretch.to_mm = to_mm;
    if (p.margin_N_per_mm() >= stretch.worst.margin_N_per_mm()) return;
    stretch.worst = p;
    stretch.falling = falling;
  }

  const ButtonState& state_;
  const ForceDeviceProfile& device_;
  LoopLimits limits_;
  SpeedDamping rendered_;
};

/// The least of several damping values up to `most` with which the slope is stable; if none is enough, the
/// one that allows the steepest slope.
double dampingFor(double slope_N_per_mm, const ForceDeviceProfile& device, double rate_Hz,
                  double most_Ns_per_mm) {
  constexpr int tries = 8;
  double best_Ns_per_mm = 0, bears_N_per_mm = loopLimit_N_per_mm(device, rate_Hz, 0);
  for (int i = 1; i <= tries && bears_N_per_mm < slope_N_per_mm; ++i) {
    const double damping_Ns_per_mm = most_Ns_per_mm * i / tries;
    const double limit_N_per_mm = loopLimit_N_per_mm(device, rate_Hz, damping_Ns_per_mm);
    if (limit_N_per_mm <= bears_N_per_mm) continue;
    bears_N_per_mm = limit_N_per_mm;
    best_Ns_per_mm = damping_Ns_per_mm;
  }
  return best_Ns_per_mm;
}

/// A stroke with limited slopes, or the unchanged stroke if none exceeds the limit. A vertical rise at the
/// end of the travel keeps the part that fits.
Result<StrokeCurve> limited(const StrokeCurve& curve, double slope_N_per_mm, StabilityChange& change) {
  const double spacing_mm = curve.travel_mm() / static_cast<double>(travelSamples);
  const auto [low_N, high_N] = curve.forceRange_N();
  const double range_N = high_N - low_N;
  std::vector<CurvePoint> points;
  double worst_N = 0;
  for (std::size_t i = 0; i <= travelSamples; ++i) {
    const double at_mm =
        i == travelSamples ? curve.end_mm() : curve.start_mm() + static_cast<double>(i) * spacing_mm;
    // For a vertical rise at the start, the first point is its lower end.
    const double wanted_N = i == 0 ? curve.forceBefore_N(at_mm) : curve.force_N(at_mm);
    double force_N = wanted_N;
    if (i > 0) {
      const double most_N = slope_N_per_mm * (at_mm - points.back().displacement_mm);
      force_N = std::clamp(wanted_N, points.back().force_N - most_N, points.back().force_N + most_N);
    }
    points.push_back({at_mm, force_N});
    if (std::abs(force_N - wanted_N) > 1e-9 * range_N) {
      if (change.changedTo_mm == 0 && change.changedFrom_mm == 0) change.changedFrom_mm = at_mm;
      change.changedTo_mm = std::max(change.changedTo_mm, at_mm);
      worst_N = std::max(worst_N, std::abs(force_N - wanted_N));
    }
  }
  if (worst_N == 0) return curve;
  change.largestForceChange_N = std::max(change.largestForceChange_N, worst_N);
  // The fit may deviate by a quarter of the margin between the rendered slope and the allowed one.
  const double spare_N = 0.25 * (1 - limitedTo) * slope_N_per_mm * spacing_mm;
  return curveThroughDensePoints(points, std::min(samplingTolerance * range_N, spare_N));
}

Result<ForceGraph> limited(const ForceGraph& graph, double slope_N_per_mm, StabilityChange& change) {
  Result<StrokeCurve> press = limited(graph.press(), slope_N_per_mm, change);
  if (!press) return press.failure();
  std::optional<StrokeCurve> release;
  if (graph.release()) {
    Result<StrokeCurve> slower = limited(*graph.release(), slope_N_per_mm, change);
    if (!slower) return slower.failure();
    release = *std::move(slower);
  }
  return ForceGraph::fromCurves(*std::move(press), std::move(release));
}

/// Size of the strongest change of force with speed, of either sign: if it acts late, both signs disturb a
/// finger.
double strongestBySpeed(const ButtonState& state, const ForceDeviceProfile& device, double rate_Hz) {
  if (state.otherSpeeds.empty()) return 0;
  const SpeedDamping rendered = renderedSpeedDamping(state, device, rate_Hz);
  double strongest = 0;
  for (std::size_t i = 0; i < travelSamples; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(travelSamples);
    const SpeedDamping there = renderedAt(state, rendered, share * state.graph.travel_mm());
    strongest = std::max({strongest, there.most, -there.least});
  }
  return strongest;
}

}  // namespace

StabilityMargin stabilityOf(const Button& button, const ForceDeviceProfile& device, double rate_Hz) {
  StabilityMargin margin;
  double strongest = 0, bySpeed = 0;
  for (std::size_t s = 0; s < button.states().size(); ++s) {
    MarginOfState(button.states()[s], device, rate_Hz).add(s, margin);
    for (const DampingPoint& d : button.states()[s].damping)
      strongest = std::max(strongest, d.damping_Ns_per_mm);
    bySpeed = std::max(bySpeed, strongestBySpeed(button.states()[s], device, rate_Hz));
  }
  margin.anyFinger_N_per_mm = (device.damping_Ns_per_mm - strongest - bySpeed) / late_s(device, rate_Hz);
  return margin;
}

Result<StableButton> nearestStable(const Button& button, const ForceDeviceProfile& device, double rate_Hz) {
  const double mostDamping = largestDamping_Ns_per_mm(device, rate_Hz);
  const StabilityMargin margin = stabilityOf(button, device, rate_Hz);
  std::vector<ButtonState> states = button.states();
  std::vector<StabilityChange> changes;
  for (std::size_t s = 0; s < states.size(); ++s) {
    ButtonState& state = states[s];
    StabilityChange change;
    change.state = s;
    double steepest_N_per_mm = 0;
    for (const MarginPoint& p : margin.states[s])
      if (p.margin_N_per_mm() < 0 && p.bound == StabilityBound::damping)
        steepest_N_per_mm = std::max(steepest_N_per_mm, p.slope_N_per_mm);
    const double needed = dampingFor(steepest_N_per_mm, device, rate_Hz, mostDamping);
    if (needed > 0) {
      change.addedDamping_Ns_per_mm = raiseDamping(state.damping, needed, state.graph.travel_mm());
    }
    const double allowed =
        allowedFor(device, limitsOf(state, device, rate_Hz).least_N_per_mm()).allowed_N_per_mm;
    if (allowed < leastAllowed_N_per_mm) {
      return Failure{FailureCode::wrongUsage, device.name, "",
                     Message("the device has so little friction or damping that no button is stable on it"),
                     Message("Give the friction and the damping of the device, or choose another device")};
    }
    Result<ForceGraph> graph = limited(state.graph, limitedTo * allowed, change);
    if (!graph) return graph.failure();
    state.graph = *std::move(graph);
    for (SpeedGraph& other : state.otherSpeeds) {
      Result<ForceGraph> limitedGraph = limited(other.graph, limitedTo * allowed, change);
      if (!limitedGraph) return limitedGraph.failure();
      other.graph = *std::move(limitedGraph);
    }
    if (change.largestForceChange_N > 0 || change.addedDamping_Ns_per_mm > 0) changes.push_back(change);
  }
  Result<Button> stable = Button::fromStates(button.name(), std::move(states), button.provenance());
  if (!stable) return stable.failure();
  return StableButton{*std::move(stable), std::move(changes)};
}

}  // namespace detent::playback
