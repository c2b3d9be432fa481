// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/speed_family.h"

// No std::ranges: libc++ 14, used for the browser module (playback/page), lacks it.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "model/check.h"

namespace detent {
namespace {

// Beyond its ends a curve keeps the force of the nearest end.
double slopeBefore(const StrokeCurve& curve, double at_mm) {
  return at_mm <= curve.start_mm() || at_mm > curve.end_mm() ? 0 : curve.slopeBefore_N_per_mm(at_mm);
}
double slopeAfter(const StrokeCurve& curve, double at_mm) {
  return at_mm < curve.start_mm() || at_mm >= curve.end_mm() ? 0 : curve.slope_N_per_mm(at_mm);
}

Result<StrokeCurve> mixed(const StrokeCurve& a, const StrokeCurve& b, double share) {
  if (a == b) return a;
  std::vector<double> positions;
  for (const StrokeCurve* curve : {&a, &b})
    for (const Knot& knot : curve->knots()) positions.push_back(knot.displacement_mm);
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  std::vector<Knot> knots;
  for (const double at_mm : positions) {
    const double before_N = std::lerp(a.forceBefore_N(at_mm), b.forceBefore_N(at_mm), share);
    const double after_N = std::lerp(a.force_N(at_mm), b.force_N(at_mm), share);
    const double before = std::lerp(slopeBefore(a, at_mm), slopeBefore(b, at_mm), share);
    const double after = std::lerp(slopeAfter(a, at_mm), slopeAfter(b, at_mm), share);
    if (before_N != after_N) knots.push_back({at_mm, before_N, before, 0});
    knots.push_back({at_mm, after_N, before_N != after_N ? 0 : before, after});
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<ForceGraph> mixed(const ForceGraph& a, const ForceGraph& b, double share) {
  auto press = mixed(a.press(), b.press(), share);
  if (!press) return press.failure();
  if (!a.release()) return ForceGraph::fromCurves(*std::move(press), {});
  auto release = mixed(*a.release(), *b.release(), share);
  if (!release) return release.failure();
  return ForceGraph::fromCurves(*std::move(press), *std::move(release));
}

Failure wrong(const char* subject, Message problem, const Message& advice) {
  return {FailureCode::wrongUsage, subject, "", std::move(problem), advice};
}

/// All graphs of a state, by rising speed.
std::vector<SpeedGraph> membersOf(const ButtonState& state) {
  std::vector<SpeedGraph> members = state.otherSpeeds;
  const auto above = std::upper_bound(
      members.begin(), members.end(), *state.speed_mm_per_s,
      [](double speed_mm_per_s, const SpeedGraph& g) { return speed_mm_per_s < g.speed_mm_per_s; });
  members.insert(above, {*state.speed_mm_per_s, state.graph});
  return members;
}

void setFront(ButtonState& state, std::vector<SpeedGraph> members, std::size_t front) {
  state.graph = members[front].graph;
  state.speed_mm_per_s = members[front].speed_mm_per_s;
  members.erase(members.begin() + static_cast<std::ptrdiff_t>(front));
  state.otherSpeeds = std::move(members);
}

}  // namespace

std::vector<double> speedsOf(const ButtonState& state) {
  std::vector<double> speeds;
  if (!state.speed_mm_per_s) return speeds;
  speeds.push_back(*state.speed_mm_per_s);
  for (const SpeedGraph& other : state.otherSpeeds) speeds.push_back(other.speed_mm_per_s);
  std::sort(speeds.begin(), speeds.end());
  return speeds;
}

std::vector<double> speedsOf(const Button& button) { return speedsOf(button.states().front()); }

const ForceGraph& graphAt(const ButtonState& state, std::size_t index) {
  if (!state.speed_mm_per_s) return state.graph;
  const auto below = static_cast<std::size_t>(
      std::count_if(state.otherSpeeds.begin(), state.otherSpeeds.end(),
                    [&](const SpeedGraph& g) { return g.speed_mm_per_s < *state.speed_mm_per_s; }));
  if (index == below) return state.graph;
  return state.otherSpeeds.at(index < below ? index : index - 1).graph;
}

SpeedPlace placeOf(const std::vector<double>& speeds, double speed_mm_per_s) {
  const auto above = std::upper_bound(speeds.begin(), speeds.end(), speed_mm_per_s);
  if (above == speeds.begin()) return {0, 0, 0};
  const auto lower = static_cast<std::size_t>(above - speeds.begin()) - 1;
  if (above == speeds.end()) return {lower, lower, 0};
  return {lower, lower + 1, (speed_mm_per_s - speeds[lower]) / (speeds[lower + 1] - speeds[lower])};
}

Result<Button> atSpeed(const Button& button, double speed_mm_per_s) {
  if (!(speed_mm_per_s > 0) || !std::isfinite(speed_mm_per_s))
    return wrong("speed", Message("%1 mm/s is not a speed above 0", speed_mm_per_s),
                 Message("Give a speed such as 50"));
  const std::vector<double> speeds = speedsOf(button);
  if (speeds.empty()) return button;
  const SpeedPlace at = placeOf(speeds, speed_mm_per_s);
  std::vector<ButtonState> states = button.states();
  for (ButtonState& state : states) {
    auto graph = at.share == 0 ? Result<ForceGraph>(graphAt(state, at.lower))
                               : mixed(graphAt(state, at.lower), graphAt(state, at.upper), at.share);
    if (!graph) return graph.failure();
    state.graph = *std::move(graph);
    state.speed_mm_per_s.reset();
    state.otherSpeeds.clear();
  }
  return Button::fromStates(button.name(), std::move(states), button.provenance());
}

Result<Button> familyOf(const std::vector<Button>& buttons, const std::vector<double>& speeds_mm_per_s) {
  if (buttons.size() < 2 || buttons.size() != speeds_mm_per_s.size())
    return wrong("speeds",
                 Message("there are %1 speeds for %2 buttons", speeds_mm_per_s.size(), buttons.size()),
                 Message("Give two to four buttons, and a speed for each"));
  for (const Button& button : buttons)
    if (button.states().size() != buttons.front().states().size())
      return wrong("buttons", "some of the buttons are momentary, others are self-locking",
                   "Choose buttons of one kind");
  std::vector<std::size_t> order(buttons.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return speeds_mm_per_s[a] < speeds_mm_per_s[b]; });
  std::vector<ButtonState> states = buttons.front().states();
  for (std::size_t s = 0; s < states.size(); ++s) {
    states[s].speed_mm_per_s = speeds_mm_per_s.front();
    states[s].otherSpeeds.clear();
    for (const std::size_t i : order)
      if (i != 0) states[s].otherSpeeds.push_back({speeds_mm_per_s[i], buttons[i].states()[s].graph});
  }
  return Button::fromStates(buttons.front().name(), std::move(states), buttons.front().provenance());
}

Button broughtForward(const Button& button, std::size_t index) {
  std::vector<ButtonState> states = button.states();
  for (ButtonState& state : states)
    if (state.speed_mm_per_s) setFront(state, membersOf(state), index);
  auto changed = Button::fromStates(button.name(), std::move(states), button.provenance());
  DETENT_CHECK(changed, "the same graphs in another order make a button");
  return *std::move(changed);
}

}  // namespace detent
