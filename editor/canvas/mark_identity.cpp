// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/mark_identity.h"

#include <algorithm>

namespace detent::editor {
namespace {

bool isSame(const Knot& a, const Knot& b) { return a == b; }
bool isSame(const TactilePoint& a, const TactilePoint& b) {
  return a.displacement_mm == b.displacement_mm && a.force_N == b.force_N;
}
bool isSame(const CurvePoint& a, const CurvePoint& b) { return a == b; }
bool isSame(const Section& a, const Section& b) {
  return a.kind == b.kind && a.from_mm == b.from_mm && a.to_mm == b.to_mm;
}

bool samePlace(const Knot& a, const Knot& b) {
  return a.displacement_mm == b.displacement_mm && a.force_N == b.force_N;
}
bool samePlace(const TactilePoint& a, const TactilePoint& b) { return isSame(a, b); }
bool samePlace(const CurvePoint& a, const CurvePoint& b) { return a == b; }
bool samePlace(const Section& a, const Section& b) { return a.kind == b.kind && a.from_mm == b.from_mm; }

template <class T>
std::optional<std::size_t> sameIndex(const std::vector<T>& before, const std::vector<T>& after,
                                     std::size_t index) {
  if (index >= before.size()) return {};
  const std::size_t shorter = std::min(before.size(), after.size());
  std::size_t head = 0, tail = 0;
  while (head < shorter && isSame(before[head], after[head])) ++head;
  while (tail < shorter - head && isSame(before[before.size() - 1 - tail], after[after.size() - 1 - tail]))
    ++tail;
  if (index < head) return index;
  if (index >= before.size() - tail) return after.size() - (before.size() - index);
  for (std::size_t i = head; i < after.size() - tail; ++i)
    if (samePlace(before[index], after[i])) return i;
  if (before.size() == after.size()) return index;
  return {};
}

std::optional<std::size_t> sameOnStroke(MarkId mark, const MarkedState& before, const MarkedState& after) {
  const StrokeValues &was = before.values.of(mark.stroke), &is = after.values.of(mark.stroke);
  switch (mark.kind) {
    case MarkKind::tactilePoint:
      return sameIndex(was.tactile, is.tactile, mark.index);
    case MarkKind::turn:
      return sameIndex(was.turns, is.turns, mark.index);
    case MarkKind::section:
      return sameIndex(was.sections, is.sections, mark.index);
    default:
      return sameIndex(before.state.graph.curve(mark.stroke).knots(),
                       after.state.graph.curve(mark.stroke).knots(), mark.index);
  }
}

}  // namespace

std::optional<MarkId> sameMark(MarkId mark, const MarkedState& before, const MarkedState& after) {
  if (mark.kind == MarkKind::operatingPoint || mark.kind == MarkKind::resetPoint)
    return placeOf(mark, after.state, after.values) ? std::optional(mark) : std::nullopt;
  if (mark.stroke == Stroke::release && !(before.state.graph.release() && after.state.graph.release()))
    return {};
  const auto index = sameOnStroke(mark, before, after);
  if (!index) return {};
  mark.index = *index;
  return mark;
}

}  // namespace detent::editor
