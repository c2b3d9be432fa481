// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/links.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

// Where an edit of a curve took each displacement: knot by knot. If their number changed, by the knots that kept
// their force, and end to end.
class MovedDisplacements {
 public:
  MovedDisplacements(const StrokeCurve& before, const StrokeCurve& after) {
    const std::vector<Knot>&from = before.knots(), &to = after.knots();
    std::size_t next = 1;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double was_mm = from[i].displacement_mm;
      if (!was_.empty() && !(was_mm > was_.back())) continue;  // a vertical piece
      std::size_t is = i;
      if (from.size() != to.size()) {
        if (i == 0 || i + 1 == from.size()) {
          is = i == 0 ? 0 : to.size() - 1;
        } else {
          for (is = next; is + 1 < to.size(); ++is)
            if (std::abs(to[is].force_N - from[i].force_N) <= rounding) break;
          if (is + 1 >= to.size()) continue;  // changed or removed
          next = is + 1;
        }
      }
      was_.push_back(was_mm);
      is_.push_back(to[is].displacement_mm);
    }
  }
  double of(double at_mm) const {
    const std::size_t i = pieceOf(at_mm, false);
    return is_[i] + (at_mm - was_[i]) * stretchOf(at_mm, false);
  }
  /// Derivative of `of` on one side of a place; outside the curve 1.
  double stretchOf(double at_mm, bool before) const {
    if (before ? at_mm <= was_.front() : at_mm < was_.front()) return 1;
    if (before ? at_mm > was_.back() : at_mm >= was_.back()) return 1;
    const std::size_t i = pieceOf(at_mm, before);
    return (is_[i + 1] - is_[i]) / (was_[i + 1] - was_[i]);
  }

 private:
  std::size_t pieceOf(double at_mm, bool before) const {
    const auto next = before ? std::lower_bound(was_.begin(), was_.end(), at_mm)
                             : std::upper_bound(was_.begin(), was_.end(), at_mm);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - was_.begin() - 1));
  }
  std::vector<double> was_, is_;
};

// Moves each knot of the release as the press moved at its displacement, and adds the press's change of slope.
Result<StrokeCurve> movedAlong(const StrokeCurve& release, const StrokeCurve& before,
                               const StrokeCurve& after) {
  const MovedDisplacements moved(before, after);
  const auto slopeOf = [&](double slope, double was, double is, double stretch) {
    return stretch > 0 ? (slope - was) / stretch + is : slope;
  };
  std::vector<Knot> knots = release.knots();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    Knot& knot = knots[i];
    const double was_mm = knot.displacement_mm, is_mm = moved.of(was_mm);
    const bool belowStep = i + 1 < knots.size() && release.knots()[i + 1].displacement_mm == was_mm;
    const double by_N = belowStep ? after.forceBefore_N(is_mm) - before.forceBefore_N(was_mm)
                                  : after.force_N(is_mm) - before.force_N(was_mm);
    knot.displacement_mm = is_mm;
    knot.force_N += by_N;
    knot.slopeBefore_N_per_mm = slopeOf(knot.slopeBefore_N_per_mm, before.slopeBefore_N_per_mm(was_mm),
                                        after.slopeBefore_N_per_mm(is_mm), moved.stretchOf(was_mm, true));
    knot.slopeAfter_N_per_mm = slopeOf(knot.slopeAfter_N_per_mm, before.slope_N_per_mm(was_mm),
                                       after.slope_N_per_mm(is_mm), moved.stretchOf(was_mm, false));
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

// Moves releases along with their presses; an edit that changed a release itself is left as it is.
Result<Button> withReleasesMoved(const Button& before, Button after) {
  for (std::size_t i = 0; i < std::min(before.states().size(), after.states().size()); ++i) {
    const ForceGraph &was = before.states()[i].graph, &is = after.states()[i].graph;
    if (was.press() == is.press() || !was.release() || was.release() != is.release()) continue;
    auto release = movedAlong(*was.release(), was.press(), is.press());
    if (!release) return release.failure();
    auto next = editGraph(
        after, i, [&](const ForceGraph& graph) { return ForceGraph::fromCurves(graph.press(), *release); });
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
  std::optional<double> end_mm;
  if (links.oneTravelEnd) {
    const auto moved = newEnd_mm(before, after);
    if (!moved) return moved.failure();
    end_mm = *moved;
  }
  if (links.releaseBelowPress_N) next = withReleasesMoved(before, after);
  if (next && end_mm) next = allEndingAt(*next, *end_mm);
  if (!next) return next;
  if (auto pin = movedPin(before, *next, links)) return *std::move(pin);
  return next;
}

Result<Button> lowerReleases(Button button, double by_N) {
  for (std::size_t i = 0; i < button.states().size(); ++i) {
    if (!button.states()[i].graph.release()) continue;
    auto next = editGraph(button, i, [&](const ForceGraph& graph) {
      return editStroke(graph, Stroke::release, [&](const StrokeCurve& curve) {
        std::vector<Knot> knots = curve.knots();
        for (Knot& knot : knots) knot.force_N -= by_N;
        return StrokeCurve::fromKnots(std::move(knots));
      });
    });
    if (!next) return next;
    button = *std::move(next);
  }
  return button;
}

}  // namespace detent
