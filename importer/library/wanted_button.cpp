// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/wanted_button.h"

#include <algorithm>
#include <cmath>

#include "importer/library/feel_distance.h"
#include "model/targets/targets.h"
#include "model/units.h"

namespace detent::importer {
namespace {

/// The size of one lab noise for a figure: its force, or a value that costs as much in FeelDistance.
double noiseOf(FigureUnit unit) {
  const double noise_N = labNoise_gf * newtonsPer(ForceUnit::gramForce);
  const double noise_mm = labNoise_gf / FeelWeights{}.travel_gf_per_mm;
  switch (unit) {
    case FigureUnit::mm:
      return noise_mm;
    case FigureUnit::N:
      return noise_N;
    case FigureUnit::N_per_mm:
      return noise_N / 0.5;  // over half a millimetre, the distance from peak to valley
    case FigureUnit::mJ:
      return noise_N * 4;  // over the 4 mm of a key switch
    case FigureUnit::share:
      return 0.06;  // of a drop on a peak of 50 gf
  }
  return 1;
}

double nearestIn(const FigureRange& range, double value) { return std::clamp(value, range.low, range.high); }

const KeyFigureName& nameOf(KeyFigure figure) { return keyFigureNames()[static_cast<std::size_t>(figure)]; }

/// A target at a bound, slightly inside the range, so that a solution within tolerance satisfies the range.
FigureTarget targetIn(const FigureRange& range, double value) {
  const double hair = std::min(1e-3, (range.high - range.low) / 2);
  const double bound = nearestIn(range, value);
  if (bound == range.low && bound != range.high) return {range.figure, bound + hair};
  if (bound == range.high && bound != range.low) return {range.figure, bound - hair};
  return {range.figure, bound};
}

/// Returns true if a value is in the range, within the tolerance of targets.
bool keeps(const FigureRange& range, double value) {
  constexpr double tolerance = 2e-4;  // N, mm, N/mm, mJ or a share
  return value >= range.low - tolerance && value <= range.high + tolerance;
}

}  // namespace

std::optional<double> missOf(const KeyFigures& figures, const std::vector<FigureRange>& ranges) {
  double sum = 0;
  for (const FigureRange& range : ranges) {
    const auto& value = figures[range.figure];
    if (!value) return {};
    const double miss = (*value - nearestIn(range, *value)) / noiseOf(nameOf(range.figure).unit);
    sum += miss * miss;
  }
  return std::sqrt(sum);
}

Result<Button> buttonWithin(const Button& button, const std::vector<FigureRange>& ranges) {
  Button bent = button;
  std::vector<FigureTarget> targets;
  for (std::size_t round = 0; round <= ranges.size(); ++round) {
    const KeyFigures figures = keyFiguresOf(bent.states().front());
    bool added = false;
    for (const FigureRange& range : ranges) {
      const auto& value = figures[range.figure];
      if (!value)
        return Failure{FailureCode::notCertain, button.name(), "",
                       Message("this button has no %1", nameOf(range.figure).key),
                       "Ask for figures it has, or for a switch that has them (--like)"};
      if (keeps(range, *value) || std::ranges::any_of(targets, [&](const FigureTarget& target) {
            return target.figure == range.figure;
          }))
        continue;
      targets.push_back(targetIn(range, *value));
      added = true;
    }
    if (!added) return bent;
    // Always starts from the original button, so that its total change is the least possible.
    TargetOutcome outcome = bentToTargets(button, 0, targets);
    if (!outcome.button) {
      Failure failure = std::move(outcome.conflict->failure);
      failure.code = FailureCode::notCertain;
      return failure;
    }
    bent = *std::move(outcome.button);
  }
  return bent;
}

}  // namespace detent::importer
