// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/links.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/edits.h"

namespace detent {
namespace {

constexpr double rounding = 1e-9;  // mm, N: smaller changes are rounding

Failure linkRefusal(Message place, Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, "links", std::move(place), std::move(problem), std::move(remedies)};
}

Message nameOf(Stroke stroke) { return stroke == Stroke::press ? Message("press") : Message("release"); }

bool has(const ButtonState& state, Stroke stroke) {
  return stroke == Stroke::press || state.graph.release().has_value();
}

// Returns the end that an edit has set; nullopt if none was moved.
Result<std::optional<double>> newEnd_mm(const Button& before, const Button& after) {
  std::optional<double> end_mm;
  for (std::size_t i = 0; i < std::min(before.states().size(), after.states().size()); ++i)
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const ButtonState &was = before.states()[i], &is = after.states()[i];
      if (!has(was, stroke) || !has(is, stroke)) continue;
      const double now_mm = is.graph.curve(stroke).end_mm();
      if (std::abs(now_mm - was.graph.curve(stroke).end_mm()) <= rounding) continue;
      if (end_mm && std::abs(*end_mm - now_mm) > rounding)
        return linkRefusal(nameOf(stroke), Message("would end at another place than the other strokes"),
                           Message("Move one end alone, or loosen the link"));
      end_mm = now_mm;
    }
  return end_mm;
}

// Moves the bottom-out as a whole to the new end and stretches the rest.
Result<StrokeCurve> endingAt(const StrokeCurve& curve, Stroke stroke, double end_mm) {
  const double by_mm = end_mm - curve.end_mm();
  if (std::abs(by_mm) <= rounding) return curve;
  const std::vector<Section> sections = sectionsOf(curve, stroke);
  for (std::size_t i = 0; i < sections.size(); ++i)
    if (sections[i].kind == SectionKind::bottomOut && sections[i].from_mm != sections[i].to_mm)
      return moveSection(curve, stroke, i, by_mm, 0);
  std::vector<KnotPlace> places;
  for (std::size_t i = 0; i < curve.knots().size(); ++i)
    if (curve.knots()[i].displacement_mm == curve.end_mm())
      places.push_back({i, {end_mm, curve.knots()[i].force_N}});
  return placeKnots(curve, places);
}

Result<ForceGraph> endingAt(const ForceGraph& graph, double end_mm) {
  auto press = endingAt(graph.press(), Stroke::press, end_mm);
  if (!press) return press.failure();
  if (!graph.release()) return ForceGraph::fromCurves(*std::move(press), {});
  auto release = endingAt(*graph.release(), Stroke::release, end_mm);
  if (!release) return release.failure();
  return ForceGraph::fromCurves(*std::move(press), *std::move(release));
}

Result<Button> allEndingAt(Button button, double end_mm) {
  for (std::size_t i = 0; i < button.states().size(); ++i) {
    auto next = editGraph(button, i, [&](const ForceGraph& graph) { return endingAt(graph, end_mm); });
    if (!next) return next;
    button = *std::move(next);
  }
  return button;
}

Result<Button> onOneEnd(const Button& before, const Button& after) {
  const auto end_mm = newEnd_mm(before, after);
  if (!end_mm) return end_mm.failure();
  return *end_mm ? allEndingAt(after, **end_mm) : Result<Button>(after);
}

Result<Button> withReleaseBelow(const Button& before, Button after, double offset_N) {
  for (std::size_t i = 0; i < after.states().size(); ++i) {
    const ForceGraph& graph = after.states()[i].graph;
    if (!graph.release()) continue;
    const ForceGraph* was = i < before.states().size() ? &before.states()[i].graph : nullptr;
    if (was && was->press() == graph.press() && was->release() && !(was->release() == graph.release()))
      return linkRefusal(nameOf(Stroke::release), Message("follows its press"),
                         Message("Edit the press, or loosen the link"));
    auto next =
        editGraph(after, i, [&](const ForceGraph& one) { return mirrorPressToRelease(one, offset_N); });
    if (!next) return next;
    after = *std::move(next);
  }
  return after;
}

std::optional<double> forceAt(const Button& button, const PinnedPoint& pin) {
  if (pin.state >= button.states().size() || !has(button.states()[pin.state], pin.stroke)) return {};
  const StrokeCurve& curve = button.states()[pin.state].graph.curve(pin.stroke);
  if (pin.displacement_mm < curve.start_mm() || pin.displacement_mm > curve.end_mm()) return {};
  return curve.force_N(pin.displacement_mm);
}

std::optional<Failure> movedPin(const Button& before, const Button& after, const EditLinks& links) {
  for (const PinnedPoint& pin : links.pinned) {
    const auto was = forceAt(before, pin), is = forceAt(after, pin);
    if (!was || (is && std::abs(*is - *was) <= rounding)) continue;
    return linkRefusal(nameOf(pin.stroke),
                       Message("would leave its pinned point at %1", millimetres(pin.displacement_mm)),
                       Message("Take the pin out, or move something else"));
  }
  return {};
}

}  // namespace

Result<Button> keptLinks(const Button& before, const Button& after, const EditLinks& links) {
  if (links.empty()) return after;
  Result<Button> next = after;
  if (links.oneTravelEnd) next = onOneEnd(before, *next);
  if (next && links.releaseBelowPress_N) next = withReleaseBelow(before, *next, *links.releaseBelowPress_N);
  if (!next) return next;
  if (auto pin = movedPin(before, *next, links)) return *std::move(pin);
  return next;
}

Result<Button> linkedTo(const Button& button, std::size_t state, const EditLinks& links) {
  Result<Button> next = button;
  if (links.oneTravelEnd) next = allEndingAt(button, button.states()[state].graph.press().end_mm());
  if (next && links.releaseBelowPress_N) next = withReleaseBelow(*next, *next, *links.releaseBelowPress_N);
  return next;
}

}  // namespace detent
