// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/force_steps.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "model/number_table.h"
#include "model/sampling.h"

namespace detent {

namespace {

struct Crossing {
  double force_N = 0, displacement_mm = 0;
};

/// Displacement where the curve has `force_N` between two samples on its two sides.
double placeBetween(const StrokeCurve& curve, const CurvePoint& a, const CurvePoint& b, double force_N) {
  double from_mm = a.displacement_mm, to_mm = b.displacement_mm;
  const bool rises = b.force_N > a.force_N;
  for (int i = 0; i < 60 && from_mm != to_mm; ++i) {
    const double middle_mm = 0.5 * (from_mm + to_mm);
    ((curve.force_N(middle_mm) < force_N) == rises ? from_mm : to_mm) = middle_mm;
  }
  return 0.5 * (from_mm + to_mm);
}

/// Multiples of a force with their decimal digits: 0.3, not 0.30000000000000004.
class Steps {
 public:
  explicit Steps(double step_N) : step_N_(step_N) {}

  double force_N(double count) const {
    char digits[40];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, count * step_N_, std::chars_format::general, 12).ptr;
    double value = 0;
    std::from_chars(digits, end, value);
    return value;
  }
  /// Factor of a force that is a multiple; nullopt otherwise.
  std::optional<double> countOf(double force_N) const {
    const double nearest = std::round(force_N / step_N_);
    return this->force_N(nearest) == force_N ? std::optional(nearest) : std::nullopt;
  }
  double above(double force_N) const { return countOf(force_N).value_or(std::floor(force_N / step_N_)) + 1; }
  double below(double force_N) const { return countOf(force_N).value_or(std::ceil(force_N / step_N_)) - 1; }

 private:
  double step_N_;
};

/// Adds the multiples between two samples, excluding that of the start and including that of the end.
void addCrossings(const StrokeCurve& curve, const CurvePoint& a, const CurvePoint& b, const Steps& steps,
                  std::vector<Crossing>& crossings) {
  if (a.force_N == b.force_N) {
    if (steps.countOf(b.force_N)) crossings.push_back({b.force_N, b.displacement_mm});
    return;
  }
  const bool rises = b.force_N > a.force_N;
  for (double count = rises ? steps.above(a.force_N) : steps.below(a.force_N);
       crossings.size() <= mostForceSteps; count += rises ? 1 : -1) {
    const double force_N = steps.force_N(count);
    if (rises ? force_N > b.force_N : force_N < b.force_N) return;
    crossings.push_back(
        {force_N, force_N == b.force_N ? b.displacement_mm : placeBetween(curve, a, b, force_N)});
  }
}

std::vector<Crossing> crossingsOf(const ForceGraph& graph, Stroke stroke, const Steps& steps) {
  const std::vector<CurvePoint> samples = travelledSamples(graph, stroke);
  std::vector<Crossing> crossings;
  const CurvePoint& first = samples.front();
  if (steps.countOf(first.force_N)) crossings.push_back({first.force_N, first.displacement_mm});
  for (std::size_t i = 1; i < samples.size() && crossings.size() <= mostForceSteps; ++i)
    addCrossings(graph.curve(stroke), samples[i - 1], samples[i], steps, crossings);
  return crossings;
}

}  // namespace

Result<std::string> forceStepsFrom(const ForceGraph& graph, double step_N) {
  if (!(step_N > 0) || !std::isfinite(step_N))
    return Failure{FailureCode::wrongUsage, Subject::option("--force-step"), "", "the step is not above 0 N",
                   "Pass a step such as 0.1"};
  std::string csv = "stroke,force_N,displacement_mm\n";
  std::size_t rows = 0;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !graph.release()) continue;
    for (const Crossing& at : crossingsOf(graph, stroke, Steps(step_N))) {
      csv += stroke == Stroke::press ? "press," : "release,";
      csv += shortestText(at.force_N) + ',' + shortestText(at.displacement_mm) + '\n';
      ++rows;
    }
  }
  if (rows > mostForceSteps)
    return Failure{FailureCode::wrongUsage, Subject::option("--force-step"), "",
                   "the step is too small: the table would have more than 100000 rows", "Pass a larger step"};
  return csv;
}

}  // namespace detent
