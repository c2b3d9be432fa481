// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/button.h"

#include <algorithm>
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
                       Message("%1 at %2 lies outside its stroke (%3 to %4)", name, millimetres(*point_mm),
                               millimetres(curve.start_mm()), millimetres(curve.end_mm())),
                       Message("Move the point inside the travel, or remove it"));
}

std::optional<Failure> dampingProblem(const Message& place, const std::vector<DampingPoint>& damping) {
  for (std::size_t i = 0; i < damping.size(); ++i) {
    const auto at = Message("%1, damping point %2", place, i + 1);
    const DampingPoint& p = damping[i];
    if (!std::isfinite(p.displacement_mm) || std::abs(p.displacement_mm) > ForceGraph::maxTravel_mm)
      return buttonFailure(at,
                           Message("displacement %1 is not a usable number", millimetres(p.displacement_mm)),
                           Message("Give a displacement inside the travel"));
    if (!std::isfinite(p.damping_Ns_per_mm) || p.damping_Ns_per_mm < 0)
      return buttonFailure(at, Message("damping %1 N·s/mm is not a number of 0 or more", p.damping_Ns_per_mm),
                           Message("Give 0 where there is no damping"));
    if (i > 0 && !(p.displacement_mm > damping[i - 1].displacement_mm))
      return buttonFailure(at,
                           Message("the displacement %1 is not above that of the previous point",
                                   millimetres(p.displacement_mm)),
                           Message("Sort the damping points by increasing displacement"));
  }
  return {};
}

Message speedText(double speed_mm_per_s) { return Message("%1 mm/s", speed_mm_per_s); }

std::optional<Failure> speedProblem(const Message& place, const ButtonState& state) {
  const std::size_t speeds = state.otherSpeeds.size() + (state.speed_mm_per_s ? 1 : 0);
  if (!state.speed_mm_per_s)
    return buttonFailure(
        place, Message("the state has graphs at other speeds, but gives no speed for its main graph"),
        Message("Give the speed of the main graph in mm/s"));
  if (state.otherSpeeds.empty())
    return buttonFailure(place,
                         Message("the state gives the speed %1, but has no graph at another speed",
                                 speedText(*state.speed_mm_per_s)),
                         Message("Add a graph at another speed, or remove the speed"));
  if (speeds > Button::mostSpeeds)
    return buttonFailure(place, Message("the state has graphs at %1 speeds, which are too many", speeds),
                         Message("Keep two to four graphs"));
  std::vector<double> stated{*state.speed_mm_per_s};
  for (const SpeedGraph& other : state.otherSpeeds) stated.push_back(other.speed_mm_per_s);
  for (std::size_t i = 0; i < stated.size(); ++i) {
    if (!(stated[i] > 0) || stated[i] > Button::largestSpeed_mm_per_s)
      return buttonFailure(
          place, Message("speed %1 is not a usable speed", speedText(stated[i])),
          Message("Give speeds above 0, up to %1", speedText(Button::largestSpeed_mm_per_s)));
    if (i > 0 && stated[i] == stated[0])
      return buttonFailure(place, Message("the state has two graphs at the speed %1", speedText(stated[i])),
                           Message("Give each graph a different speed"));
    if (i > 1 && !(stated[i] > stated[i - 1]))
      return buttonFailure(
          place,
          Message("speed %1 is not above the previous speed %2", speedText(stated[i]),
                  speedText(stated[i - 1])),
          Message("Sort the other graphs by increasing speed, and use each speed only once"));
  }
  return {};
}

// Strokes of one button must end alike at all speeds, because forces are mixed at equal displacements.
std::optional<Failure> familyProblem(const Message& place, const ButtonState& state) {
  if (!state.speed_mm_per_s && state.otherSpeeds.empty()) return {};
  if (auto problem = speedProblem(place, state)) return problem;
  const Message own = speedText(*state.speed_mm_per_s);
  const double apart_mm = Button::familyTravelShare * state.graph.travel_mm();
  for (const SpeedGraph& other : state.otherSpeeds) {
    const auto at = Message("%1, %2", place, speedText(other.speed_mm_per_s));
    if (other.graph.release().has_value() != state.graph.release().has_value())
      return buttonFailure(at,
                           other.graph.release()
                               ? Message("this graph has a release, but the graph at %1 has none", own)
                               : Message("this graph has no release, but the graph at %1 has one", own),
                           Message("Give the graphs of all speeds a release, or none of them"));
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const StrokeCurve &mine = state.graph.curve(stroke), &theirCurve = other.graph.curve(stroke);
      for (const auto& [from_mm, to_mm] :
           {std::pair{theirCurve.start_mm(), mine.start_mm()}, std::pair{theirCurve.end_mm(), mine.end_mm()}})
        if (std::abs(from_mm - to_mm) > apart_mm)
          return buttonFailure(
              at,
              Message("the %1 has an end at %2, but at %4 in the graph of %3; they may differ by %5 at most",
                      stroke == Stroke::press ? Message("press") : Message("release"), millimetres(from_mm),
                      own, millimetres(to_mm), millimetres(apart_mm)),
              Message("Give graphs of one button, with the same travel"));
    }
    if (auto problem =
            pointProblem(at, Message("operating point"), state.operatingPoint_mm, other.graph.press()))
      return problem;
    if (auto problem =
            pointProblem(at, Message("reset point"), state.resetPoint_mm, other.graph.curve(Stroke::release)))
      return problem;
  }
  return {};
}

bool atTheSameSpeeds(const std::vector<SpeedGraph>& a, const std::vector<SpeedGraph>& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.speed_mm_per_s == y.speed_mm_per_s;
  });
}

std::optional<Failure> differentSpeeds(const std::vector<ButtonState>& states) {
  const ButtonState& first = states[0];
  for (std::size_t i = 1; i < states.size(); ++i) {
    const ButtonState& state = states[i];
    if (state.speed_mm_per_s && first.speed_mm_per_s && *state.speed_mm_per_s != *first.speed_mm_per_s)
      return buttonFailure(
          placeOf(states, i),
          Message("the main graph of this state has the speed %1, but that of %2 has %3",
                  speedText(*state.speed_mm_per_s), placeOf(states, 0), speedText(*first.speed_mm_per_s)),
          Message("Choose the same speed for the main graph of every state"));
    if (state.speed_mm_per_s != first.speed_mm_per_s ||
        !atTheSameSpeeds(state.otherSpeeds, first.otherSpeeds))
      return buttonFailure(
          placeOf(states, i),
          Message("the graphs of this state have other speeds than those of %1", placeOf(states, 0)),
          Message("Give every state graphs at the same speeds"));
  }
  return {};
}

std::optional<Failure> stateProblem(const std::vector<ButtonState>& states, std::size_t index) {
  const ButtonState& state = states[index];
  const Message place = placeOf(states, index);
  for (std::size_t other = 0; other < index; ++other)
    if (states[other].name == state.name)
      return buttonFailure(place, Message("this state has the same name as state %1", other + 1),
                           Message("Give each state its own name"));
  if (auto problem =
          pointProblem(place, Message("operating point"), state.operatingPoint_mm, state.graph.press()))
    return problem;
  if (auto problem = pointProblem(place, Message("reset point"), state.resetPoint_mm,
                                  state.graph.curve(Stroke::release)))
    return problem;
  if (auto problem = dampingProblem(place, state.damping)) return problem;
  return familyProblem(place, state);
}

std::optional<Failure> provenanceProblem(const Provenance& provenance) {
  const auto fault = [](const Message& what, double value) {
    return buttonFailure(Message("provenance"), Message("%1 is %2, not a usable number", what, value),
                         Message("Leave out values that you do not know"));
  };
  for (double edge : provenance.frame)
    if (!std::isfinite(edge)) return fault(Message("frame edge"), edge);
  for (const auto& axis : {provenance.xAxis, provenance.yAxis}) {
    if (!axis) continue;
    for (double value : {axis->min, axis->max, axis->residual_px})
      if (!std::isfinite(value)) return fault(Message("axis value"), value);
  }
  for (double value : {provenance.pressRms_px, provenance.releaseRms_px, provenance.confidence})
    if (!std::isfinite(value)) return fault(Message("deviation or confidence"), value);
  return {};
}

}  // namespace

Result<Button> Button::fromStates(std::string name, std::vector<ButtonState> states,
                                  std::optional<Provenance> provenance) {
  if (states.empty() || states.size() > 2)
    return buttonFailure("", Message("the button has %1 states, but it needs one or two", states.size()),
                         Message("Give one state (momentary) or two (self-locking)"));
  for (std::size_t i = 0; i < states.size(); ++i)
    if (auto problem = stateProblem(states, i)) return *problem;
  if (auto problem = differentSpeeds(states)) return *problem;
  if (provenance)
    if (auto problem = provenanceProblem(*provenance)) return *problem;
  return Button(std::move(name), std::move(states), std::move(provenance));
}

}  // namespace detent
