// SPDX-License-Identifier: GPL-3.0-or-later
// Edits that scale, and edits of graphs and buttons.
#include <cmath>
#include <cstdio>

#include "model/edits.h"
#include "model/metrics.h"

namespace detent {
namespace {

Failure refusal(Subject subject, Message place, Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, std::move(subject), std::move(place), std::move(problem),
          std::move(remedies)};
}

std::optional<Failure> factorProblem(double factor) {
  if (std::isfinite(factor) && factor > 0) return {};
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", factor);
  return refusal("scale", "", Message("factor %1 is not a number above 0", text),
                 Message("Give a factor such as 1.1"));
}

Result<ForceGraph> editBothStrokes(const ForceGraph& graph, const CurveEdit& edit) {
  auto press = edit(graph.press());
  if (!press) return press.failure();
  if (!graph.release()) return ForceGraph::fromCurves(*std::move(press), {});
  auto release = edit(*graph.release());
  if (!release) return release.failure();
  return ForceGraph::fromCurves(*std::move(press), *std::move(release));
}

// Distance of a mirrored release below its press, with its derivative. A force >= 0 stays >= 0.
struct Lowered {
  double force_N, slopeFactor;
};

Lowered lowered(double force_N, double hysteresis_N) {
  if (force_N >= 2 * hysteresis_N) return {force_N - hysteresis_N, 1};
  if (force_N <= 0) return {force_N, 0};
  return {force_N * (force_N / (4 * hysteresis_N)), force_N / (2 * hysteresis_N)};
}

using StateEdit = std::function<std::optional<Failure>(ButtonState&)>;

Result<Button> editState(const Button& button, std::size_t index, const StateEdit& edit) {
  if (index >= button.states().size())
    return refusal("button", "", Message("the button has no state %1", index + 1),
                   Message("Choose one of the states of the button"));
  std::vector<ButtonState> states = button.states();
  if (auto problem = edit(states[index])) return *problem;
  return Button::fromStates(button.name(), std::move(states), button.provenance());
}

Result<Button> editAllStates(const Button& button, const StateEdit& edit) {
  std::vector<ButtonState> states = button.states();
  for (ButtonState& state : states)
    if (auto problem = edit(state)) return *problem;
  return Button::fromStates(button.name(), std::move(states), button.provenance());
}

std::optional<Failure> editAllSpeeds(ButtonState& state, const GraphEdit& edit) {
  const auto change = [&](ForceGraph& graph) -> std::optional<Failure> {
    auto edited = edit(graph);
    if (!edited) return edited.failure();
    graph = *std::move(edited);
    return {};
  };
  if (auto problem = change(state.graph)) return problem;
  for (SpeedGraph& other : state.otherSpeeds)
    if (auto problem = change(other.graph)) return problem;
  return {};
}

}  // namespace

Result<StrokeCurve> scaleForce(const StrokeCurve& curve, double factor) {
  if (auto problem = factorProblem(factor)) return *problem;
  std::vector<Knot> knots = curve.knots();
  for (Knot& k : knots) {
    k.force_N *= factor;
    k.slopeBefore_N_per_mm *= factor;
    k.slopeAfter_N_per_mm *= factor;
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<StrokeCurve> scaleTravel(const StrokeCurve& curve, double factor) {
  if (auto problem = factorProblem(factor)) return *problem;
  std::vector<Knot> knots = curve.knots();
  for (Knot& k : knots) {
    k.displacement_mm *= factor;
    k.slopeBefore_N_per_mm /= factor;
    k.slopeAfter_N_per_mm /= factor;
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<ForceGraph> editStroke(const ForceGraph& graph, Stroke stroke, const CurveEdit& edit) {
  if (stroke == Stroke::release && !graph.release())
    return refusal(
        "force graph", Message("release curve"), Message("there is no release curve"),
        Message("Create a release curve first (in the window: Edit > Curve > Mirror press to release)"));
  auto edited = edit(graph.curve(stroke));
  if (!edited) return edited.failure();
  if (stroke == Stroke::press) return ForceGraph::fromCurves(*std::move(edited), graph.release());
  return ForceGraph::fromCurves(graph.press(), *std::move(edited));
}

Result<ForceGraph> mirrorPressToRelease(const ForceGraph& graph, double hysteresis_N) {
  if (!std::isfinite(hysteresis_N) || hysteresis_N < 0)
    return refusal("force graph", Message("hysteresis"),
                   Message("the hysteresis is not a number of 0 or more"),
                   Message("Give a force in N, 0 for none"));
  std::vector<Knot> knots = graph.press().knots();
  for (Knot& k : knots) {
    if (hysteresis_N == 0) continue;
    const Lowered low = lowered(k.force_N, hysteresis_N);
    k.force_N = low.force_N;
    k.slopeBefore_N_per_mm *= low.slopeFactor;
    k.slopeAfter_N_per_mm *= low.slopeFactor;
  }
  auto release = StrokeCurve::fromKnots(std::move(knots));
  if (!release) return release.failure();
  return ForceGraph::fromCurves(graph.press(), *std::move(release));
}

Result<ForceGraph> removeRelease(const ForceGraph& graph) {
  return ForceGraph::fromCurves(graph.press(), {});
}

Result<ForceGraph> scaleForce(const ForceGraph& graph, double factor) {
  return editBothStrokes(graph, [&](const StrokeCurve& curve) { return scaleForce(curve, factor); });
}

Result<ForceGraph> scaleTravel(const ForceGraph& graph, double factor) {
  return editBothStrokes(graph, [&](const StrokeCurve& curve) { return scaleTravel(curve, factor); });
}

Result<Button> editGraph(const Button& button, std::size_t state, const GraphEdit& edit) {
  return editState(button, state, [&](ButtonState& s) -> std::optional<Failure> {
    auto edited = edit(s.graph);
    if (!edited) return edited.failure();
    s.graph = *std::move(edited);
    return {};
  });
}

Result<Button> rename(const Button& button, std::string name) {
  return Button::fromStates(std::move(name), button.states(), button.provenance());
}

Result<Button> setOperatingPoint(const Button& button, std::size_t state,
                                 std::optional<double> displacement_mm) {
  return editState(button, state, [&](ButtonState& s) -> std::optional<Failure> {
    s.operatingPoint_mm = displacement_mm;
    return {};
  });
}

Result<Button> setResetPoint(const Button& button, std::size_t state, std::optional<double> displacement_mm) {
  return editState(button, state, [&](ButtonState& s) -> std::optional<Failure> {
    s.resetPoint_mm = displacement_mm;
    return {};
  });
}

Result<Button> setDamping(const Button& button, std::size_t state, std::vector<DampingPoint> damping) {
  return editState(button, state, [&](ButtonState& s) -> std::optional<Failure> {
    s.damping = std::move(damping);
    return {};
  });
}

Result<Button> addState(const Button& button, std::size_t of) {
  std::vector<ButtonState> states = button.states();
  if (of >= states.size())
    return refusal("button", "", Message("the button has no state %1", of + 1),
                   Message("Choose one of the states of the button"));
  if (states.size() > 1)
    return refusal("button", "", Message("the button already has two states"),
                   Message("Remove one of the states first"));
  if (states[of].name.empty()) states[of].name = "unlocked";
  states.push_back(states[of]);
  states.back().name = states[of].name == "locked" ? "unlocked" : "locked";
  return Button::fromStates(button.name(), std::move(states), button.provenance());
}

Result<Button> removeState(const Button& button, std::size_t state) {
  std::vector<ButtonState> states = button.states();
  if (state >= states.size())
    return refusal("button", "", Message("the button has no state %1", state + 1),
                   Message("Choose one of the states of the button"));
  if (states.size() == 1)
    return refusal("button", "", Message("the button has only this state"),
                   Message("Add a second state first"));
  states.erase(states.begin() + static_cast<std::ptrdiff_t>(state));
  return Button::fromStates(button.name(), std::move(states), button.provenance());
}

Result<Button> scaleForce(const Button& button, double factor) {
  return editAllStates(button, [&](ButtonState& s) -> std::optional<Failure> {
    if (auto problem = editAllSpeeds(s, [&](const ForceGraph& graph) { return scaleForce(graph, factor); }))
      return problem;
    for (DampingPoint& p : s.damping) p.damping_Ns_per_mm *= factor;
    return {};
  });
}

Result<Button> scaleTravel(const Button& button, double factor) {
  return editAllStates(button, [&](ButtonState& s) -> std::optional<Failure> {
    if (auto problem = editAllSpeeds(s, [&](const ForceGraph& graph) { return scaleTravel(graph, factor); }))
      return problem;
    if (s.operatingPoint_mm) *s.operatingPoint_mm *= factor;
    if (s.resetPoint_mm) *s.resetPoint_mm *= factor;
    for (DampingPoint& p : s.damping) p.displacement_mm *= factor;
    return {};
  });
}

Result<Button> scaleSnapRatios(const Button& button, double factor) {
  Result<Button> changed = button;
  for (std::size_t s = 0; s < button.states().size(); ++s) {
    const StrokeMetrics press = metricsOf(button.states()[s].graph.press(), Stroke::press);
    for (std::size_t t = 0; t < press.tactile.size() && changed; ++t) {
      if (!press.tactile[t].snapRatio) continue;
      changed = editGraph(*changed, s, [&](const ForceGraph& graph) {
        return editStroke(graph, Stroke::press, [&](const StrokeCurve& curve) {
          return setSnapRatio(curve, t, *press.tactile[t].snapRatio * factor);
        });
      });
    }
  }
  return changed;
}

}  // namespace detent
