// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/force_graph.h"

#include <cmath>
#include <string>

namespace detent {
namespace {

Failure graphFailure(Message curve, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, "force graph", std::move(curve), std::move(problem),
          std::move(remedies)};
}

std::optional<Failure> curveProblem(const StrokeCurve& curve, const Message& name) {
  const auto [low, high] = curve.forceRange_N();
  const double worst = std::abs(low) > std::abs(high) ? low : high;
  if (std::abs(worst) > ForceGraph::maxForce_N)
    return graphFailure(
        name,
        Message("force reaches %1, beyond the limit of ±%2", newtons(worst), newtons(ForceGraph::maxForce_N)),
        Message("Check the unit of the force axis"));
  if (curve.travel_mm() > ForceGraph::maxTravel_mm || curve.end_mm() > ForceGraph::maxTravel_mm)
    return graphFailure(name,
                        Message("displacement reaches %1, beyond the limit of %2",
                                millimetres(curve.end_mm()), millimetres(ForceGraph::maxTravel_mm)),
                        Message("Check the unit of the displacement axis"));
  return {};
}

std::optional<Failure> releaseProblem(const StrokeCurve& press, const StrokeCurve& release) {
  if (auto problem = curveProblem(release, Message("release curve"))) return problem;
  if (release.end_mm() > press.start_mm() && release.start_mm() < press.end_mm()) return {};
  return graphFailure(Message("release curve"),
                      Message("the release curve runs from %1 to %2, but the press curve from %3 to %4",
                              millimetres(release.start_mm()), millimetres(release.end_mm()),
                              millimetres(press.start_mm()), millimetres(press.end_mm())),
                      Message("Measure the displacement of both strokes from the same zero"));
}

}  // namespace

Result<ForceGraph> ForceGraph::fromCurves(StrokeCurve press, std::optional<StrokeCurve> release) {
  if (press.start_mm() < 0)
    return graphFailure(Message("press curve"),
                        Message("the press curve starts at %1, before 0", millimetres(press.start_mm())),
                        Message("Move the curve so that it starts at 0 mm or later"));
  if (auto problem = curveProblem(press, Message("press curve"))) return *problem;
  if (release)
    if (auto problem = releaseProblem(press, *release)) return *problem;
  return ForceGraph(std::move(press), std::move(release));
}

}  // namespace detent
