// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/selection_edits.h"

#include <algorithm>
#include <functional>

#include "editor/tools/mark_edits.h"

namespace detent::editor {
namespace {

Failure selectionRefusal(Message problem, const Message& remedy) {
  return {FailureCode::wrongUsage, "selection", "", std::move(problem), remedy};
}

std::vector<std::size_t> knotsOf(const std::vector<MarkId>& marks, Stroke stroke) {
  std::vector<std::size_t> knots;
  for (const MarkId& mark : marks)
    if (mark.kind == MarkKind::knot && mark.stroke == stroke) knots.push_back(mark.index);
  std::sort(knots.begin(), knots.end());
  return knots;
}

using KnotsEdit = std::function<Result<StrokeCurve>(const StrokeCurve&, const std::vector<std::size_t>&)>;

Result<StrokeCurve> editThese(const StrokeCurve& curve, const std::vector<std::size_t>& knots,
                              const KnotsEdit& edit) {
  if (knots.back() >= curve.knots().size())
    return selectionRefusal(Message("one of the selected curve points no longer exists"),
                            Message("Select the points again"));
  return edit(curve, knots);
}

// Both strokes together, because half of an edit could break a rule of the graph.
Result<Button> editKnots(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                         const KnotsEdit& edit) {
  return editGraph(button, state, [&](const ForceGraph& graph) -> Result<ForceGraph> {
    StrokeCurve press = graph.press();
    std::optional<StrokeCurve> release = graph.release();
    if (const auto knots = knotsOf(marks, Stroke::press); !knots.empty()) {
      auto edited = editThese(press, knots, edit);
      if (!edited) return edited.failure();
      press = *std::move(edited);
    }
    if (const auto knots = knotsOf(marks, Stroke::release); release && !knots.empty()) {
      auto edited = editThese(*release, knots, edit);
      if (!edited) return edited.failure();
      release = *std::move(edited);
    }
    return ForceGraph::fromCurves(std::move(press), std::move(release));
  });
}

using ContactEdit = std::function<std::optional<double>(double displacement_mm)>;

Result<Button> editContacts(Button button, std::size_t state, const std::vector<MarkId>& marks,
                            const ContactEdit& edit) {
  for (const MarkId& mark : marks) {
    if (!isContact(mark.kind)) continue;
    const bool operating = mark.kind == MarkKind::operatingPoint;
    const ButtonState& now = button.states()[state];
    const auto at_mm = operating ? now.operatingPoint_mm : now.resetPoint_mm;
    if (!at_mm) continue;
    auto next = operating ? setOperatingPoint(button, state, edit(*at_mm))
                          : setResetPoint(button, state, edit(*at_mm));
    if (!next) return next;
    button = *std::move(next);
  }
  return button;
}

double partOf(CurvePoint at, GraphDirection direction) {
  return direction == GraphDirection::displacement ? at.displacement_mm : at.force_N;
}

CurvePoint with(CurvePoint at, GraphDirection direction, double value) {
  (direction == GraphDirection::displacement ? at.displacement_mm : at.force_N) = value;
  return at;
}

CurvePoint placeOf(const StrokeCurve& curve, std::size_t knot) {
  return {curve.knots()[knot].displacement_mm, curve.knots()[knot].force_N};
}

}  // namespace

std::vector<MarkId> pointsOf(MarkId mark, const ButtonState& state, const GraphValues& values) {
  if (isContact(mark.kind) || mark.kind == MarkKind::knot) return {mark};
  if (isSlope(mark.kind)) return {{MarkKind::knot, mark.stroke, mark.index}};
  const StrokeCurve& curve = state.graph.curve(mark.stroke);
  if (mark.kind != MarkKind::section) {
    const auto at = editor::placeOf(mark, state, values);
    const auto knot = at ? knotAt(curve, at->displacement_mm) : std::nullopt;
    if (!knot) return {};
    return {{MarkKind::knot, mark.stroke, *knot}};
  }
  const auto& sections = values.of(mark.stroke).sections;
  if (mark.index >= sections.size()) return {};
  const auto [from, to] = std::minmax(sections[mark.index].from_mm, sections[mark.index].to_mm);
  std::vector<MarkId> points;
  for (std::size_t i = 0; i < curve.knots().size(); ++i)
    if (curve.knots()[i].displacement_mm >= from && curve.knots()[i].displacement_mm <= to)
      points.push_back({MarkKind::knot, mark.stroke, i});
  return points;
}

std::vector<MarkId> allPoints(const ButtonState& state) {
  std::vector<MarkId> points;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !state.graph.release()) continue;
    for (std::size_t i = 0; i < state.graph.curve(stroke).knots().size(); ++i)
      points.push_back({MarkKind::knot, stroke, i});
  }
  if (state.operatingPoint_mm) points.push_back({MarkKind::operatingPoint, Stroke::press, 0});
  if (state.resetPoint_mm) points.push_back({MarkKind::resetPoint, Stroke::release, 0});
  return points;
}

Result<Button> moveSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                             double by_mm, double by_N) {
  // Contacts are removed first and set again last: they could lie outside a travel that shrinks, or that
  // grows only later.
  auto bare = editContacts(button, state, marks, [](double) { return std::optional<double>(); });
  if (!bare) return bare;
  auto moved =
      editKnots(*bare, state, marks, [&](const StrokeCurve& curve, const std::vector<std::size_t>& knots) {
        std::vector<KnotPlace> moves;
        for (const std::size_t knot : knots) {
          const CurvePoint at = placeOf(curve, knot);
          moves.push_back({knot, {at.displacement_mm + by_mm, at.force_N + by_N}});
        }
        return placeKnots(curve, moves);
      });
  if (!moved) return moved;
  const ButtonState& before = button.states()[state];
  for (const MarkId& mark : marks) {
    if (!isContact(mark.kind)) continue;
    const bool operating = mark.kind == MarkKind::operatingPoint;
    const auto at_mm = operating ? before.operatingPoint_mm : before.resetPoint_mm;
    if (!at_mm) continue;
    moved = operating ? setOperatingPoint(*moved, state, *at_mm + by_mm)
                      : setResetPoint(*moved, state, *at_mm + by_mm);
    if (!moved) return moved;
  }
  return moved;
}

Result<Button> removeSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks) {
  auto bare = editContacts(button, state, marks, [](double) { return std::optional<double>(); });
  if (!bare) return bare;
  return editKnots(*bare, state, marks, [](const StrokeCurve& curve, const std::vector<std::size_t>& knots) {
    return removeKnots(curve, knots);
  });
}

Result<Button> alignSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                              GraphDirection direction) {
  const auto last =
      std::find_if(marks.rbegin(), marks.rend(), [](MarkId m) { return m.kind == MarkKind::knot; });
  if (last == marks.rend() || marks.size() < 2)
    return selectionRefusal(
        Message("fewer than two curve points are selected"),
        Message("Select two or more curve points; the others are aligned with the last one"));
  const StrokeCurve& of = button.states()[state].graph.curve(last->stroke);
  if (last->index >= of.knots().size())
    return selectionRefusal(Message("one of the selected curve points no longer exists"),
                            Message("Select the points again"));
  const double level = partOf(placeOf(of, last->index), direction);
  return editKnots(button, state, marks,
                   [&](const StrokeCurve& curve, const std::vector<std::size_t>& knots) {
                     std::vector<KnotPlace> moves;
                     for (const std::size_t knot : knots)
                       moves.push_back({knot, with(placeOf(curve, knot), direction, level)});
                     return placeKnots(curve, moves);
                   });
}

Result<Button> distributeSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                                   GraphDirection direction) {
  if (knotsOf(marks, Stroke::press).size() < 3 && knotsOf(marks, Stroke::release).size() < 3)
    return selectionRefusal(Message("fewer than three curve points of one stroke are selected"),
                            Message("Select three or more points; the outer two stay in place"));
  return editKnots(
      button, state, marks,
      [&](const StrokeCurve& curve, const std::vector<std::size_t>& knots) -> Result<StrokeCurve> {
        if (knots.size() < 3) return curve;
        const double from = partOf(placeOf(curve, knots.front()), direction);
        const double to = partOf(placeOf(curve, knots.back()), direction);
        std::vector<KnotPlace> moves;
        for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
          const double share = static_cast<double>(i) / static_cast<double>(knots.size() - 1);
          moves.push_back({knots[i], with(placeOf(curve, knots[i]), direction, from + share * (to - from))});
        }
        return placeKnots(curve, moves);
      });
}

}  // namespace detent::editor
