// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/button.h"

#include <cmath>
#include <cstdio>

namespace detent {
namespace {

std::string numberText(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.9g", value);
  return buffer;
}

Failure buttonFailure(Message place, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, "button", std::move(place), std::move(problem), std::move(remedies)};
}

std::string placeOf(const std::vector<ButtonState>& states, std::size_t index) {
  const std::string& name = states[index].name;
  return "state " + (name.empty() ? std::to_string(index + 1) : "\"" + name + "\"");
}

std::optional<Failure> pointProblem(const std::string& place, const char* name,
                                    std::optional<double> point_mm, const StrokeCurve& curve) {
  if (!point_mm) return {};
  if (*point_mm >= curve.start_mm() && *point_mm <= curve.end_mm()) return {};
  return buttonFailure(place,
                       std::string(name) + " at " + numberText(*point_mm) + " mm lies outside its stroke, " +
                           numberText(curve.start_mm()) + " to " + numberText(curve.end_mm()) + " mm",
                       "Move it inside the travel or leave it out");
}

std::optional<Failure> dampingProblem(const std::string& place, const std::vector<DampingPoint>& damping) {
  for (std::size_t i = 0; i < damping.size(); ++i) {
    const std::string at = place + ", damping point " + std::to_string(i + 1);
    const DampingPoint& p = damping[i];
    if (!std::isfinite(p.displacement_mm) || std::abs(p.displacement_mm) > ForceGraph::maxTravel_mm)
      return buttonFailure(at, "displacement " + numberText(p.displacement_mm) + " mm is not a usable number",
                           "Give a displacement inside the travel");
    if (!std::isfinite(p.damping_Ns_per_mm) || p.damping_Ns_per_mm < 0)
      return buttonFailure(at,
                           "damping " + numberText(p.damping_Ns_per_mm) + " N·s/mm is not finite and >= 0",
                           "Give 0 where there is no damping");
    if (i > 0 && !(p.displacement_mm > damping[i - 1].displacement_mm))
      return buttonFailure(at, "displacement " + numberText(p.displacement_mm) + " mm does not increase",
                           "Order damping points by increasing displacement");
  }
  return {};
}

std::optional<Failure> stateProblem(const std::vector<ButtonState>& states, std::size_t index) {
  const ButtonState& state = states[index];
  const std::string place = placeOf(states, index);
  for (std::size_t other = 0; other < index; ++other)
    if (states[other].name == state.name)
      return buttonFailure(place, "has the same name as state " + std::to_string(other + 1),
                           "Give each state its own name");
  if (auto problem = pointProblem(place, "operating point", state.operatingPoint_mm, state.graph.press()))
    return problem;
  if (auto problem =
          pointProblem(place, "reset point", state.resetPoint_mm, state.graph.curve(Stroke::release)))
    return problem;
  return dampingProblem(place, state.damping);
}

std::optional<Failure> provenanceProblem(const Provenance& provenance) {
  const auto fault = [](const std::string& what, double value) {
    return buttonFailure("provenance", what + " is " + numberText(value) + ", not a finite number",
                         "Leave out what is not known");
  };
  for (double edge : provenance.frame)
    if (!std::isfinite(edge)) return fault("frame edge", edge);
  for (const auto& axis : {provenance.xAxis, provenance.yAxis}) {
    if (!axis) continue;
    for (double value : {axis->min, axis->max, axis->residual_px})
      if (!std::isfinite(value)) return fault("axis value", value);
  }
  for (double value : {provenance.pressRms_px, provenance.releaseRms_px, provenance.confidence})
    if (!std::isfinite(value)) return fault("residual or confidence", value);
  return {};
}

}  // namespace

Result<Button> Button::fromStates(std::string name, std::vector<ButtonState> states,
                                  std::optional<Provenance> provenance) {
  if (states.empty() || states.size() > 2)
    return buttonFailure("", "has " + std::to_string(states.size()) + " states",
                         "Give one state (momentary) or two (self-locking)");
  for (std::size_t i = 0; i < states.size(); ++i)
    if (auto problem = stateProblem(states, i)) return *problem;
  if (provenance)
    if (auto problem = provenanceProblem(*provenance)) return *problem;
  return Button(std::move(name), std::move(states), std::move(provenance));
}

}  // namespace detent
