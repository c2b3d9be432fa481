// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/force_graph.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace detent {
namespace {

std::string numberText(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.9g", value);
  return buffer;
}

Failure graphFailure(Message curve, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, "force graph", std::move(curve), std::move(problem),
          std::move(remedies)};
}

std::optional<Failure> curveProblem(const StrokeCurve& curve, const Message& name) {
  const auto [low, high] = curve.forceRange_N();
  const double worst = std::abs(low) > std::abs(high) ? low : high;
  if (std::abs(worst) > ForceGraph::maxForce_N)
    return graphFailure(name,
                        "force reaches " + numberText(worst) + " N, beyond the limit of ±" +
                            numberText(ForceGraph::maxForce_N) + " N",
                        "Check the unit of the force axis");
  if (curve.travel_mm() > ForceGraph::maxTravel_mm || curve.end_mm() > ForceGraph::maxTravel_mm)
    return graphFailure(name,
                        "displacement reaches " + numberText(curve.end_mm()) + " mm, beyond the limit of " +
                            numberText(ForceGraph::maxTravel_mm) + " mm",
                        "Check the unit of the displacement axis");
  return {};
}

std::optional<Failure> releaseProblem(const StrokeCurve& press, const StrokeCurve& release) {
  if (auto problem = curveProblem(release, "release curve")) return problem;
  if (release.end_mm() > press.start_mm() && release.start_mm() < press.end_mm()) return {};
  return graphFailure("release curve",
                      "covers " + numberText(release.start_mm()) + " to " + numberText(release.end_mm()) +
                          " mm, beside the press curve's " + numberText(press.start_mm()) + " to " +
                          numberText(press.end_mm()) + " mm",
                      "Bring both strokes to the same displacement axis");
}

}  // namespace

Result<ForceGraph> ForceGraph::fromCurves(StrokeCurve press, std::optional<StrokeCurve> release) {
  if (press.start_mm() < 0)
    return graphFailure("press curve", "starts at " + numberText(press.start_mm()) + " mm, before 0 mm",
                        "Move the curve so that it starts at 0 mm or later");
  if (auto problem = curveProblem(press, "press curve")) return *problem;
  if (release)
    if (auto problem = releaseProblem(press, *release)) return *problem;
  return ForceGraph(std::move(press), std::move(release));
}

}  // namespace detent
