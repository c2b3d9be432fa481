// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/unit_spread.h"

#include <algorithm>
#include <cmath>

#include "model/blend.h"
#include "model/sampling.h"

namespace detent {
namespace {

constexpr std::size_t bandPoints = 201;

/// Share of the force range by which the thinned mean may differ; the full mean has the knots of all units.
constexpr double thinnedWithin = 1e-4;

struct Moments {
  double mean = 0;
  std::optional<double> sd;  ///< none of a single value
};

Moments momentsOf(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Moments moments;
  for (const double value : values) moments.mean += value / count;
  if (values.size() < 2) return moments;
  double sum = 0;
  for (const double value : values) sum += (value - moments.mean) * (value - moments.mean);
  moments.sd = std::sqrt(sum / (count - 1));
  return moments;
}

double medianOf(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

struct Range_mm {
  double from = 0, to = 0;
};

using Curves = std::vector<const StrokeCurve*>;

Range_mm commonRange(const Curves& curves) {
  Range_mm range{curves.front()->start_mm(), curves.front()->end_mm()};
  for (const StrokeCurve* curve : curves)
    range = {std::max(range.from, curve->start_mm()), std::min(range.to, curve->end_mm())};
  return range;
}

std::vector<double> forcesAt(const Curves& curves, double displacement_mm) {
  std::vector<double> forces;
  for (const StrokeCurve* curve : curves) forces.push_back(curve->forceBefore_N(displacement_mm));
  return forces;
}

double displacementIn(Range_mm range, std::size_t i) {
  return range.from + (range.to - range.from) * static_cast<double>(i) / double(bandPoints - 1);
}

// Deviation of the units from the mean curve. The mean curve is aligned by features, so it differs from the
// mean of the forces at one displacement and could leave a band around that.
ToleranceBand bandOf(const Curves& curves, const StrokeCurve& mean) {
  const Range_mm range = commonRange(curves);
  ToleranceBand band;
  if (!(range.from < range.to)) return band;
  for (std::size_t i = 0; i < bandPoints; ++i) {
    const double at_mm = displacementIn(range, i);
    const double mean_N = mean.forceBefore_N(at_mm);
    double squares = 0;
    for (const double force_N : forcesAt(curves, at_mm)) squares += (force_N - mean_N) * (force_N - mean_N);
    band.push_back({at_mm, mean_N, std::sqrt(squares / static_cast<double>(curves.size() - 1))});
  }
  return band;
}

/// Presses of one state, and releases where all units have one.
Curves curvesOf(const std::vector<Button>& units, std::size_t state, Stroke stroke) {
  Curves curves;
  for (const Button& unit : units) {
    const ForceGraph& graph = unit.states()[state].graph;
    if (stroke == Stroke::release && !graph.release()) return {};
    curves.push_back(&graph.curve(stroke));
  }
  return curves;
}

std::vector<FigureSpread> figuresOf(const std::vector<Button>& units, std::size_t state,
                                    const SectionSettings& settings) {
  std::vector<KeyFigures> all;
  for (const Button& unit : units) all.push_back(keyFiguresOf(unit.states()[state], settings));
  std::vector<FigureSpread> spreads;
  for (const KeyFigureName& name : keyFigureNames()) {
    std::vector<double> values;
    for (const KeyFigures& figures : all)
      if (figures[name.figure]) values.push_back(*figures[name.figure]);
    if (values.empty()) continue;
    const Moments moments = momentsOf(values);
    const auto [least, most] = std::ranges::minmax(values);
    spreads.push_back({name.figure, values.size(), moments.mean, moments.sd, least, most});
  }
  return spreads;
}

/// Distance of every unit from the median, over the press of the first state up to the first bottom-out.
std::vector<double> distancesOf(const Curves& presses, const SectionSettings& settings) {
  Range_mm range = commonRange(presses);
  for (const StrokeCurve* press : presses)
    range.to = std::min(range.to, bottomOutOf(*press, settings).displacement_mm);
  std::vector<double> sums(presses.size());
  for (std::size_t i = 0; i < bandPoints; ++i) {
    const std::vector<double> forces = forcesAt(presses, displacementIn(range, i));
    const double median = medianOf(forces);
    for (std::size_t unit = 0; unit < forces.size(); ++unit)
      sums[unit] += (forces[unit] - median) * (forces[unit] - median);
  }
  for (double& sum : sums) sum = std::sqrt(sum / double(bandPoints));
  return sums;
}

std::vector<std::size_t> outliersOf(const std::vector<double>& distances) {
  std::vector<std::size_t> outliers;
  if (distances.size() < fewestForOutliers) return outliers;
  const double bar = outlierRatio * medianOf(distances);
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (distances[i] > bar) outliers.push_back(i);
  return outliers;
}

Result<StrokeCurve> thinned(const StrokeCurve& curve) {
  const auto [least, most] = curve.forceRange_N();
  const double tolerance_N = thinnedWithin * (most - least);
  if (!(tolerance_N > 0)) return curve;
  return curveThroughDensePoints(samplesOf(curve, tolerance_N / 4), tolerance_N);
}

Result<Button> thinned(const Button& button) {
  std::vector<ButtonState> states = button.states();
  for (ButtonState& state : states) {
    auto press = thinned(state.graph.press());
    if (!press) return press.failure();
    std::optional<StrokeCurve> release;
    if (state.graph.release()) {
      auto thin = thinned(*state.graph.release());
      if (!thin) return thin.failure();
      release = std::move(*thin);
    }
    auto graph = ForceGraph::fromCurves(std::move(*press), std::move(release));
    if (!graph) return graph.failure();
    state.graph = std::move(*graph);
  }
  return Button::fromStates(button.name(), std::move(states));
}

}  // namespace

Result<UnitSpread> spreadOf(const std::vector<Button>& units, const SectionSettings& settings) {
  const auto refuse = [](Message problem, const Message& advice) {
    return Failure{FailureCode::wrongUsage, "specimens", "", std::move(problem), advice};
  };
  if (units.size() < 2)
    return refuse(Message("an average needs at least two specimens"),
                  Message("Give every specimen that was measured"));
  auto blended = blend(units, std::vector<double>(units.size(), 1.0), settings);
  if (!blended) return blended.failure();
  const Curves presses = curvesOf(units, 0, Stroke::press);
  const Range_mm range = commonRange(presses);
  if (!(range.from < range.to))
    return refuse(Message("no displacement lies within the travel of all specimens"),
                  Message("Choose specimens of the same button"));
  auto mean = thinned(*blended);
  if (!mean) return mean.failure();
  UnitSpread spread{std::move(*mean), {}, distancesOf(presses, settings), {}};
  spread.outliers = outliersOf(spread.distance_N);
  for (std::size_t state = 0; state < units.front().states().size(); ++state) {
    const ForceGraph& graph = spread.mean.states()[state].graph;
    StateSpread each{
        figuresOf(units, state, settings), bandOf(curvesOf(units, state, Stroke::press), graph.press()), {}};
    const Curves releases = curvesOf(units, state, Stroke::release);
    if (!releases.empty() && graph.release()) each.release = bandOf(releases, *graph.release());
    spread.states.push_back(std::move(each));
  }
  return spread;
}

}  // namespace detent
