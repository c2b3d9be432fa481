// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/figure_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace detent::importer {
namespace {

/// Whether a figure says where the peak, the valley or the foot of the wall is, or is made of these.
bool isOfPlaces(KeyFigure figure) {
  return (figure >= KeyFigure::peakForce && figure <= KeyFigure::slopeToBottomOut) ||
         figure == KeyFigure::bottomOutForce || figure == KeyFigure::bottomOutTravel;
}

/// Variances gathered way by way.
class Variances {
 public:
  explicit Variances(const KeyFigures& figures) : figures_(figures) {}

  /// The figures of a state one standard error away. One that it does not have says nothing.
  void add(const KeyFigures& away, double weight, bool placesOnly) {
    for (std::size_t i = 0; i < keyFigureCount; ++i)
      if (figures_.values[i] && away.values[i] && (!placesOnly || isOfPlaces(static_cast<KeyFigure>(i))))
        sums_[i] += weight * std::pow(*away.values[i] - *figures_.values[i], 2);
  }

  KeyFigures roots() const {
    KeyFigures sigmas;
    for (std::size_t i = 0; i < keyFigureCount; ++i)
      if (figures_.values[i]) sigmas.values[i] = std::sqrt(sums_[i]);
    return sigmas;
  }

 private:
  const KeyFigures& figures_;
  std::array<double, keyFigureCount> sums_{};
};

StrokeCurve shifted(const StrokeCurve& curve, double by_mm) {
  std::vector<Knot> knots = curve.knots();
  for (Knot& knot : knots) knot.displacement_mm += by_mm;
  return *StrokeCurve::fromKnots(std::move(knots));
}

/// The figures with other strokes; nothing where they make no graph. A press may begin before 0, where no graph does: it is looked at
/// further on.
std::optional<KeyFigures> figuresWith(const ButtonState& state, const StrokeCurve& press,
                                      const std::optional<StrokeCurve>& release) {
  const double on_mm = std::max(0.0, -press.start_mm());
  auto graph = ForceGraph::fromCurves(shifted(press, on_mm),
                                      release ? std::optional(shifted(*release, on_mm)) : std::nullopt);
  if (!graph) return {};
  ButtonState other = state;
  other.graph = *std::move(graph);
  for (std::optional<double>* contact_mm : {&other.operatingPoint_mm, &other.resetPoint_mm})
    if (*contact_mm) **contact_mm += on_mm;
  KeyFigures figures = keyFiguresOf(other);
  for (const KeyFigure place :
       {KeyFigure::peakTravel, KeyFigure::valleyTravel, KeyFigure::resetTravel, KeyFigure::bottomOutTravel})
    if (figures[place]) *figures[place] -= on_mm;
  return figures;
}

/// Median distance of neighbours along the travel.
double step_mm(const std::vector<CurvePoint>& points) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = std::abs(points[i].displacement_mm - points[i - 1].displacement_mm);
    if (step > 0) steps.push_back(step);
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// What of a stroke may be otherwise in one way.
std::vector<const CurveAway*> doubtsOf(const StrokeReport& stroke, bool depth) {
  std::vector<const CurveAway*> doubts;
  for (const CurveAway& away : stroke.fit.oneSigmaAway)
    if ((away.doubt == CurveDoubt::depth) == depth) doubts.push_back(&away);
  return doubts;
}

}  // namespace

KeyFigures figureErrorsOf(const ImportReport& report) {
  const ButtonState& state = report.button.states().front();
  const KeyFigures figures = keyFiguresOf(state);
  Variances variances(figures);
  const StrokeCurve& press = state.graph.press();
  const std::optional<StrokeCurve>& release = state.graph.release();
  const auto take = [&](const StrokeCurve& pressAway, const std::optional<StrokeCurve>& releaseAway,
                        const CurveAway& way) {
    if (const auto away = figuresWith(state, pressAway, releaseAway))
      variances.add(*away, way.weight, way.doubt == CurveDoubt::places);
  };
  for (const CurveAway* way : doubtsOf(report.press, false)) take(way->curve, release, *way);
  if (report.release)
    for (const CurveAway* way : doubtsOf(*report.release, false)) take(press, way->curve, *way);
  // Both strokes end at the deepest sample: what one is off there the other is.
  const auto pressDepths = doubtsOf(report.press, true);
  const auto releaseDepths =
      report.release ? doubtsOf(*report.release, true) : std::vector<const CurveAway*>{};
  for (std::size_t i = 0; i < std::max(pressDepths.size(), releaseDepths.size()); ++i)
    take(i < pressDepths.size() ? pressDepths[i]->curve : press,
         i < releaseDepths.size() ? std::optional(releaseDepths[i]->curve) : release,
         i < pressDepths.size() ? *pressDepths[i] : *releaseDepths[i]);
  // A contact closes somewhere between two samples.
  const auto takeContact = [&](std::optional<double> ButtonState::*contact_mm, double step) {
    if (!(state.*contact_mm)) return;
    ButtonState away = state;
    *(away.*contact_mm) += step / std::sqrt(12.0);
    variances.add(keyFiguresOf(away), 1, false);
  };
  const double pressStep_mm = step_mm(report.strokes.press.points);
  takeContact(&ButtonState::operatingPoint_mm, pressStep_mm);
  takeContact(&ButtonState::resetPoint_mm,
              report.strokes.release ? step_mm(report.strokes.release->points) : pressStep_mm);
  return variances.roots();
}

}  // namespace detent::importer
