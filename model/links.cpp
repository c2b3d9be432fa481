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
        return linkRefusal(nameOf(stroke),
                           Message("this stroke would no longer end where the other strokes end"),
                           Message("Move only one end, or remove the link between the ends"));
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
  std::vector<KnotPlace> positions;
  for (std::size_t i = 0; i < curve.knots().size(); ++i)
    if (curve.knots()[i].displacement_mm == curve.end_mm())
      positions.push_back({i, {end_mm, curve.knots()[i].force_N}});
  return placeKnots(curve, positions);
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

// Indices of a knot before an edit and of the same knot after it.
struct SameKnot {
  std::size_t was, is;
};

// Pairs the knots of a curve and its edited form, in order and end to end. Of the longer list some stay
// alone: those whose partners would have moved farthest.
std::vector<SameKnot> sameKnots(const StrokeCurve& before, const StrokeCurve& after) {
  const std::vector<Knot>&was = before.knots(), &is = after.knots();
  const bool added = is.size() > was.size();
  const std::vector<Knot>&few = added ? was : is, &many = added ? is : was;
  const auto pairOf = [&](std::size_t i, std::size_t j) { return added ? SameKnot{i, j} : SameKnot{j, i}; };
  std::size_t head = 1, tail = 1;  // the ends belong together
  while (head + tail < few.size() && few[head] == many[head]) ++head;
  while (head + tail < few.size() && few[few.size() - 1 - tail] == many[many.size() - 1 - tail]) ++tail;
  std::vector<SameKnot> pairs;
  for (std::size_t i = 0; i < head; ++i) pairs.push_back(pairOf(i, i));
  const std::size_t rows = few.size() - head - tail, columns = many.size() - head - tail;
  constexpr std::size_t mostPairs = 1000000;
  if (few.size() == many.size()) {
    for (std::size_t i = 0; i < rows; ++i) pairs.push_back(pairOf(head + i, head + i));
  } else if (rows > 0 && rows <= mostPairs / columns) {
    const auto [low_N, high_N] = before.forceRange_N();
    const double span_mm = before.travel_mm(), span_N = std::max(high_N - low_N, rounding);
    const auto cost = [&](std::size_t i, std::size_t j) {
      const Knot &a = few[head + i], &b = many[head + j];
      return std::pow((a.displacement_mm - b.displacement_mm) / span_mm, 2) +
             std::pow((a.force_N - b.force_N) / span_N, 2);
    };
    // least[i][j]: least cost of pairing the first i of the few with some of the first j of the many
    std::vector<std::vector<double>> least(rows + 1, std::vector<double>(columns + 1, 0));
    for (std::size_t i = 1; i <= rows; ++i)
      for (std::size_t j = i; j <= columns; ++j) {
        const double paired = least[i - 1][j - 1] + cost(i - 1, j - 1);
        least[i][j] = j > i ? std::min(paired, least[i][j - 1]) : paired;
      }
    std::vector<std::size_t> partner(rows);
    for (std::size_t i = rows, j = columns; i > 0; --j)
      if (j == i || least[i][j] < least[i][j - 1]) partner[--i] = j - 1;
    for (std::size_t i = 0; i < rows; ++i) pairs.push_back(pairOf(head + i, head + partner[i]));
  }
  for (std::size_t k = tail; k > 0; --k) pairs.push_back(pairOf(few.size() - k, many.size() - k));
  return pairs;
}

// Returns true if a knot is an end, or the curve would have another shape without it.
bool shapes(const StrokeCurve& curve, std::size_t index) {
  const auto without = removeKnot(curve, index);
  if (!without || index == 0 || index + 1 == curve.knots().size()) return true;
  const double at_mm = curve.knots()[index].displacement_mm;
  const double middles_mm[] = {0.5 * (curve.knots()[index - 1].displacement_mm + at_mm), at_mm,
                               0.5 * (curve.knots()[index + 1].displacement_mm + at_mm)};
  return std::ranges::any_of(
      middles_mm, [&](double mm) { return std::abs(without->force_N(mm) - curve.force_N(mm)) > rounding; });
}

// Maps each displacement before an edit of a curve to its place after it: linear between the knots that both
// forms have, and the knots that the edit added. An added knot came from where the curve had its force, if
// that is one place.
class MovedDisplacements {
 public:
  MovedDisplacements(const StrokeCurve& before, const StrokeCurve& after) {
    const std::vector<SameKnot> same = sameKnots(before, after);
    for (std::size_t i = 0; i < same.size(); ++i) {
      if (i > 0) addBetween(before, after, same[i - 1], same[i]);
      add(before.knots()[same[i].was].displacement_mm, after.knots()[same[i].is].displacement_mm);
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
  /// Displacements before the edit of the knots that it added, as far as they shape the curve.
  const std::vector<double>& added_mm() const { return added_mm_; }

 private:
  // Two knots at one displacement are one place.
  void add(double was_mm, double is_mm) {
    if (!was_.empty() && !(was_mm > was_.back())) return;
    was_.push_back(was_mm);
    is_.push_back(is_mm);
  }
  void addBetween(const StrokeCurve& before, const StrokeCurve& after, SameKnot from, SameKnot to) {
    const double end_mm = before.knots()[to.was].displacement_mm,
                 newEnd_mm = after.knots()[to.is].displacement_mm;
    for (std::size_t j = from.is + 1; j < to.is; ++j) {
      const Knot& knot = after.knots()[j];
      const double start_mm = was_.back(), newStart_mm = is_.back();
      if (!(start_mm < end_mm) || !(newStart_mm < newEnd_mm)) return;
      double was_mm =
          start_mm + (knot.displacement_mm - newStart_mm) / (newEnd_mm - newStart_mm) * (end_mm - start_mm);
      std::vector<double> there = before.displacementsAt(knot.force_N);
      std::erase_if(there, [&](double mm) { return !(mm > start_mm && mm < end_mm); });
      if (there.size() == 1) was_mm = there.front();
      if (shapes(after, j)) added_mm_.push_back(was_mm);
      add(was_mm, knot.displacement_mm);
    }
  }
  std::size_t pieceOf(double at_mm, bool before) const {
    const auto next = before ? std::lower_bound(was_.begin(), was_.end(), at_mm)
                             : std::upper_bound(was_.begin(), was_.end(), at_mm);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, next - was_.begin() - 1));
  }
  std::vector<double> was_, is_, added_mm_;
};

// Moves each knot of the release as the press moved at its displacement, and adds the press's change of
// slope. The release gets a knot wherever the edit gave the press a new one, so that it can bend there too.
Result<StrokeCurve> movedAlong(StrokeCurve release, const StrokeCurve& before, const StrokeCurve& after) {
  const MovedDisplacements moved(before, after);
  for (const double at_mm : moved.added_mm()) {
    const bool there = std::ranges::any_of(release.knots(), [&](const Knot& knot) {
      return std::abs(knot.displacement_mm - at_mm) <= rounding;
    });
    if (there || at_mm < release.start_mm() || at_mm > release.end_mm()) continue;
    auto with = insertKnot(release, at_mm);
    if (!with) return with;
    release = *std::move(with);
  }
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
    if (was_mm > before.start_mm())  // outside the press, its force is constant
      knot.slopeBefore_N_per_mm = slopeOf(knot.slopeBefore_N_per_mm, before.slopeBefore_N_per_mm(was_mm),
                                          after.slopeBefore_N_per_mm(is_mm), moved.stretchOf(was_mm, true));
    if (was_mm < before.end_mm())
      knot.slopeAfter_N_per_mm = slopeOf(knot.slopeAfter_N_per_mm, before.slope_N_per_mm(was_mm),
                                         after.slope_N_per_mm(is_mm), moved.stretchOf(was_mm, false));
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

// Moves releases along with their presses. An edit that changed a release itself, or the number of states,
// is left as it is.
Result<Button> withReleasesMoved(const Button& before, Button after) {
  if (before.states().size() != after.states().size()) return after;
  for (std::size_t i = 0; i < after.states().size(); ++i) {
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
    return linkRefusal(
        nameOf(pin.stroke),
        Message("the curve would leave its locked point at %1", millimetres(pin.displacement_mm)),
        Message("Unlock the point, or move something else"));
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
