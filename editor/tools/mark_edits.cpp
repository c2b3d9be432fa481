// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/mark_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <QCoreApplication>
#include <utility>

namespace detent::editor {
namespace {

constexpr double bendRounding_N = 1e-9;

QString tr(const char* text) { return QCoreApplication::translate("MarkEdits", text); }

Failure markRefusal(Message place, Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, "force graph", std::move(place), std::move(problem), std::move(remedies)};
}

Result<Button> editCurve(const Button& button, std::size_t state, Stroke stroke, const CurveEdit& edit) {
  return editGraph(button, state, [&](const ForceGraph& graph) { return editStroke(graph, stroke, edit); });
}

// The slope of a handle dragged to a place; a Failure if that is straight above or on the other side.
Result<double> slopeTowards(const Knot& knot, MarkKind side, CurvePoint to) {
  const double away_mm = to.displacement_mm - knot.displacement_mm;
  if (side == MarkKind::slopeBefore ? away_mm < 0 : away_mm > 0) return (to.force_N - knot.force_N) / away_mm;
  return markRefusal(Message("slope handle"),
                     Message("the handle would move to the other side of its curve point"),
                     side == MarkKind::slopeBefore ? Message("Keep the handle left of the curve point")
                                                   : Message("Keep the handle right of the curve point"));
}

Result<StrokeCurve> withSlope(const StrokeCurve& curve, MarkId handle, double slope, SlopeSides sides) {
  if (sides == SlopeSides::asItIs && !isCorner(curve, handle.index))
    return setSlope(curve, handle.index, slope);
  return handle.kind == MarkKind::slopeBefore ? setSlopeBefore(curve, handle.index, slope)
                                              : setSlopeAfter(curve, handle.index, slope);
}

std::size_t turnsOf(const StrokeCurve& curve) {
  return curve.localMaxima().size() + curve.localMinima().size();
}

bool turnsWithin(const StrokeCurve& curve, double from_mm, double to_mm) {
  for (const auto& turns : {curve.localMaxima(), curve.localMinima()})
    for (const CurvePoint& turn : turns)
      if (turn.displacement_mm > from_mm && turn.displacement_mm < to_mm) return true;
  return false;
}

// Changes two slopes by the least amount that adds `by_N` = weights[0] * d0 + weights[1] * d1, within their
// ranges.
struct BentSlope {
  double slope, weight, least, most;
};
bool bend(std::array<BentSlope, 2>& slopes, double by_N) {
  for (int pass = 0; pass < 2; ++pass) {
    double squares = 0;
    for (const BentSlope& s : slopes) squares += s.weight * s.weight;
    double done_N = 0;
    for (BentSlope& s : slopes) {
      const double to = std::clamp(s.slope + by_N * s.weight / squares, s.least, s.most);
      done_N += s.weight * (to - s.slope);
      s.slope = to;
    }
    by_N -= done_N;
    // If one slope has reached its limit, the other slope takes the rest of the change.
    for (BentSlope& s : slopes)
      if (by_N * s.weight > 0 ? s.slope == s.most : s.slope == s.least) s.weight = 0;
    if (by_N == 0 || (slopes[0].weight == 0 && slopes[1].weight == 0)) break;
  }
  return std::abs(by_N) <= bendRounding_N;
}

// Bends the segment between two knots so that its force at a displacement grows by `by_N`. At a knot, the
// point in the middle of the adjacent segment is taken. The knots and everything outside the segment stay. A
// segment that only rises or only falls still does so afterwards.
Result<StrokeCurve> bendSegment(const StrokeCurve& curve, double at_mm, double by_N) {
  std::vector<Knot> knots = curve.knots();
  std::size_t right = 1;
  while (right + 1 < knots.size() && knots[right].displacement_mm <= at_mm) ++right;
  Knot &from = knots[right - 1], &to = knots[right];
  const double width_mm = to.displacement_mm - from.displacement_mm;
  const auto cannot = [&](Message problem) {
    return markRefusal(Message("piece between curve points %1 and %2", right, right + 1), std::move(problem),
                       Message("Add a curve point there (K) and move the new point"));
  };
  if (!(width_mm > 0)) return cannot(Message("this piece is vertical"));
  double share = (at_mm - from.displacement_mm) / width_mm;
  // the grabbed point lies on a knot, as the middle of a section may
  if (!(share > 0 && share < 1)) share = 0.5;
  const double chord = (to.force_N - from.force_N) / width_mm;
  // times the chord's slope: up to this ratio a cubic stays monotone (Fritsch and Carlson)
  constexpr double steepest = 3;
  const bool monotone = !turnsWithin(curve, from.displacement_mm, to.displacement_mm);
  const double free = std::numeric_limits<double>::max();
  const auto range = [&](double slope, double weight) {
    if (!monotone) return BentSlope{slope, weight, -free, free};
    return BentSlope{slope, weight, std::min({slope, 0.0, steepest * chord}),
                     std::max({slope, 0.0, steepest * chord})};
  };
  std::array<BentSlope, 2> slopes{
      range(from.slopeAfter_N_per_mm, width_mm * share * (1 - share) * (1 - share)),
      range(to.slopeBefore_N_per_mm, -width_mm * share * share * (1 - share))};
  if (!bend(slopes, by_N)) return cannot(Message("this piece would get an extra peak or valley"));
  from.slopeAfter_N_per_mm = slopes[0].slope;
  to.slopeBefore_N_per_mm = slopes[1].slope;
  auto bent = StrokeCurve::fromKnots(std::move(knots));
  if (!bent) return bent;
  if (turnsOf(*bent) != turnsOf(curve))
    return cannot(Message("this piece would get an extra peak or valley"));
  return bent;
}

Result<StrokeCurve> moveOnStroke(const StrokeCurve& curve, const Mark& mark, CurvePoint to,
                                 SlopeSides sides) {
  const MarkId id = mark.id;
  switch (id.kind) {
    case MarkKind::tactilePoint:
      return moveTactilePoint(curve, id.stroke, id.index, to);
    case MarkKind::turn:
      return moveTurn(curve, mark.at, to);
    case MarkKind::section:
      return bendSegment(curve, mark.at.displacement_mm, to.force_N - mark.at.force_N);
    case MarkKind::slopeBefore:
    case MarkKind::slopeAfter: {
      // reports which index is missing
      if (id.index >= curve.knots().size()) return moveKnot(curve, id.index, to);
      auto slope = slopeTowards(curve.knots()[id.index], id.kind, to);
      if (!slope) return slope.failure();
      return withSlope(curve, id, *slope, sides);
    }
    default:
      return moveKnot(curve, id.index, to);
  }
}

}  // namespace

Result<Button> moveMark(const Button& button, std::size_t state, const Mark& mark, CurvePoint to,
                        SlopeSides sides) {
  if (mark.id.kind == MarkKind::operatingPoint) return setOperatingPoint(button, state, to.displacement_mm);
  if (mark.id.kind == MarkKind::resetPoint) return setResetPoint(button, state, to.displacement_mm);
  return editCurve(button, state, mark.id.stroke,
                   [&](const StrokeCurve& curve) { return moveOnStroke(curve, mark, to, sides); });
}

Result<Button> setMarkSlope(const Button& button, std::size_t state, MarkId handle, double slope_N_per_mm,
                            SlopeSides sides) {
  return editCurve(button, state, handle.stroke,
                   [&](const StrokeCurve& curve) { return withSlope(curve, handle, slope_N_per_mm, sides); });
}

Result<Button> moveSectionEnd(const Button& button, std::size_t state, Stroke stroke, const Section& section,
                              CurvePoint to) {
  const double end_mm = section.to_mm;
  return editCurve(button, state, stroke, [&](const StrokeCurve& curve) -> Result<StrokeCurve> {
    const std::vector<TactilePoint> tactile = tactilePoints(curve, stroke);
    for (std::size_t i = 0; i < tactile.size(); ++i)
      if (tactile[i].displacement_mm == end_mm) return moveTactilePoint(curve, stroke, i, to);
    for (const auto& turns : {curve.localMaxima(), curve.localMinima()})
      for (const CurvePoint& turn : turns)
        if (turn.displacement_mm == end_mm) return moveTurn(curve, turn, to);
    if (const auto knot = knotAt(curve, end_mm)) return moveKnot(curve, *knot, to);
    auto added = insertKnot(curve, end_mm);
    if (!added) return added;
    return moveKnot(*added, *knotAt(*added, end_mm), to);
  });
}

Result<Button> removeMark(const Button& button, std::size_t state, MarkId mark) {
  switch (mark.kind) {
    case MarkKind::operatingPoint:
      return setOperatingPoint(button, state, {});
    case MarkKind::resetPoint:
      return setResetPoint(button, state, {});
    case MarkKind::tactilePoint:
      return editCurve(button, state, mark.stroke,
                       [&](const StrokeCurve& curve) { return removeJump(curve, mark.stroke, mark.index); });
    case MarkKind::knot:
      return editCurve(button, state, mark.stroke,
                       [&](const StrokeCurve& curve) { return removeKnot(curve, mark.index); });
    default:
      return markRefusal(nameOf(mark).toStdString(), Message("this element cannot be removed on its own"),
                         Message("Select a curve point, a tactile point, or the operating or reset point"));
  }
}

Result<Button> toggleCorner(const Button& button, std::size_t state, MarkId knot) {
  return editCurve(button, state, knot.stroke, [&](const StrokeCurve& curve) {
    return isCorner(curve, knot.index) ? makeSmooth(curve, knot.index) : makeCorner(curve, knot.index);
  });
}

Result<Button> addKnot(const Button& button, std::size_t state, Stroke stroke, double displacement_mm) {
  return editCurve(button, state, stroke,
                   [&](const StrokeCurve& curve) { return insertKnot(curve, displacement_mm); });
}

Result<Button> addJumpAt(const Button& button, std::size_t state, Stroke stroke, NewJump jump) {
  return editCurve(button, state, stroke,
                   [&](const StrokeCurve& curve) { return addJump(curve, stroke, jump); });
}

std::optional<std::size_t> knotAt(const StrokeCurve& curve, double displacement_mm) {
  for (std::size_t i = 0; i < curve.knots().size(); ++i)
    if (curve.knots()[i].displacement_mm == displacement_mm) return i;
  return {};
}

QString moveLabel(MarkId mark) {
  return (isSlope(mark.kind) ? tr("Change: %1") : tr("Move: %1")).arg(nameOf(mark));
}

QString removeLabel(MarkId mark) { return tr("Remove: %1").arg(nameOf(mark)); }

}  // namespace detent::editor
