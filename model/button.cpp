// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/button.h"

#include <cmath>

namespace detent {
namespace {

Failure buttonFailure(Message place, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, "button", std::move(place), std::move(problem), std::move(remedies)};
}

Message placeOf(const std::vector<ButtonState>& states, std::size_t index) {
  const std::string& name = states[index].name;
  return name.empty() ? Message("state %1", index + 1) : Message("state \"%1\"", name);
}

std::optional<Failure> pointProblem(const Message& place, const Message& name, std::optional<double> point_mm,
                                    const StrokeCurve& curve) {
  if (!point_mm) return {};
  if (*point_mm >= curve.start_mm() && *point_mm <= curve.end_mm()) return {};
  return buttonFailure(place,
                       Message("%1 at %2 lies outside its stroke, %3 to %4", name, millimetres(*point_mm),
                               millimetres(curve.start_mm()), millimetres(curve.end_mm())),
                       Message("Move it inside the travel or leave it out"));
}

std::optional<Failure> dampingProblem(const Message& place, const std::vector<DampingPoint>& damping) {
  for (std::size_t i = 0; i < damping.size(); ++i) {
    const Message at("%1, damping point %2", place, i + 1);
    const DampingPoint& p = damping[i];
    if (!std::isfinite(p.displacement_mm) || std::abs(p.displacement_mm) > ForceGraph::maxTravel_mm)
      return buttonFailure(at,
                           Message("displacement %1 is not a usable number", millimetres(p.displacement_mm)),
                           Message("Give a displacement inside the travel"));
    if (!std::isfinite(p.damping_Ns_per_mm) || p.damping_Ns_per_mm < 0)
      return buttonFailure(at, Message("damping %1 N·s/mm is not finite and >= 0", p.damping_Ns_per_mm),
                           Message("Give 0 where there is no damping"));
    if (i > 0 && !(p.displacement_mm > damping[i - 1].displacement_mm))
      return buttonFailure(at, Message("displacement %1 does not increase", millimetres(p.displacement_mm)),
                           Message("Order damping points by increasing displacement"));
  }
  return {};
}

std::optional<Failure> stateProblem(const std::vector<ButtonState>& states, std::size_t index) {
  const ButtonState& state = states[index];
  const Message place = placeOf(states, index);
  for (std::size_t other = 0; other < index; ++other)
    if (states[other].name == state.name)
      return buttonFailure(place, Message("has the same name as state %1", other + 1),
                           Message("Give each state its own name"));
  if (auto problem =
          pointProblem(place, Message("operating point"), state.operatingPoint_mm, state.graph.press()))
    return problem;
  if (auto problem = pointProblem(place, Message("reset point"), state.resetPoint_mm,
                                  state.graph.curve(Stroke::release)))
    return problem;
  return dampingProblem(place, state.damping);
}

std::optional<Failure> provenanceProblem(const Provenance& provenance) {
  const auto fault = [](const Message& what, double value) {
    return buttonFailure(Message("provenance"), Message("%1 is %2, not a finite number", what, value),
                         Message("Leave out what is not known"));
  };
  for (double edge : provenance.frame)
    if (!std::isfinite(edge)) return fault(Message("frame edge"), edge);
  for (const auto& axis : {provenance.xAxis, provenance.yAxis}) {
    if (!axis) continue;
    for (double value : {axis->min, axis->max, axis->residual_px})
      if (!std::isfinite(value)) return fault(Message("axis value"), value);
  }
  for (double value : {provenance.pressRms_px, provenance.releaseRms_px, provenance.confidence})
    if (!std::isfinite(value)) return fault(Message("residual or confidence"), value);
  return {};
}

}  // namespace

Result<Button> Button::fromStates(std::string name, std::vector<ButtonState> states,
                                  std::optional<Provenance> provenance) {
  if (states.empty() || states.size() > 2)
    return buttonFailure("", Message("has %1 states", states.size()),
                         Message("Give one state (momentary) or two (self-locking)"));
  for (std::size_t i = 0; i < states.size(); ++i)
    if (auto problem = stateProblem(states, i)) return *problem;
  if (provenance)
    if (auto problem = provenanceProblem(*provenance)) return *problem;
  return Button(std::move(name), std::move(states), std::move(provenance));
}

}  // namespace detent
