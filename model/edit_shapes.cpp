// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of shapes: tactile points, sections, jumps.
#include <algorithm>
#include <cmath>

#include "model/check.h"
#include "model/edits.h"

namespace detent {
namespace {

Failure shapeRefusal(Message place, Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, "stroke curve", std::move(place), std::move(problem), std::move(remedies)};
}

// Adds a knot without changing the shape, unless one (or a vertical piece) is there already.
StrokeCurve withKnotAt(const StrokeCurve& curve, double displacement_mm) {
  auto inserted = insertKnot(curve, displacement_mm);
  return inserted ? *std::move(inserted) : curve;
}

// Index of the knot at a place on the curve; of the two knots of a vertical piece, the one with that force.
std::size_t knotAt(const std::vector<Knot>& knots, CurvePoint place) {
  std::size_t best = knots.size();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (knots[i].displacement_mm != place.displacement_mm) continue;
    if (best == knots.size() ||
        std::abs(knots[i].force_N - place.force_N) < std::abs(knots[best].force_N - place.force_N))
      best = i;
  }
  DETENT_CHECK(best < knots.size(), "a knot was inserted at this place");
  return best;
}

// Like withKnotAt, at an extremum: the slope becomes exactly 0, so that the knot stays the extremum under
// affine maps.
StrokeCurve withExtremumKnotAt(const StrokeCurve& curve, CurvePoint extremum) {
  auto inserted = insertKnot(curve, extremum.displacement_mm);
  if (!inserted) return curve;
  std::vector<Knot> knots = inserted->knots();
  Knot& knot = knots[knotAt(knots, extremum)];
  knot.slopeBefore_N_per_mm = knot.slopeAfter_N_per_mm = 0;
  auto exact = StrokeCurve::fromKnots(std::move(knots));
  return exact ? *std::move(exact) : *std::move(inserted);
}

// Stretch of one flank: its far end stays, the apex moves.
struct AffineMap {
  CurvePoint anchor;
  double scale_mm, scale_N;
  double scaleOfSlopes;  // N/mm to N/mm

  double mapped_mm(double x) const {
    return anchor.displacement_mm + (x - anchor.displacement_mm) * scale_mm;
  }
  double mapped_N(double force) const { return anchor.force_N + (force - anchor.force_N) * scale_N; }
  double mappedSlope(double slope) const { return slope * scaleOfSlopes; }
};

// Map of a flank. A vertical or level flank has no slope to scale and gets level ends.
AffineMap flankMap(CurvePoint anchor, CurvePoint apex, CurvePoint to) {
  const double width_mm = apex.displacement_mm - anchor.displacement_mm,
               height_N = apex.force_N - anchor.force_N;
  const double scale_mm = width_mm == 0 ? 1 : (to.displacement_mm - anchor.displacement_mm) / width_mm;
  const double scale_N = height_N == 0 ? 1 : (to.force_N - anchor.force_N) / height_N;
  return {anchor, scale_mm, scale_N, width_mm == 0 ? 0 : scale_N / scale_mm};
}

// An extremum and the ends of its two flanks.
struct Hill {
  CurvePoint before, apex, after;
};

// Returns true if `a` comes before `b` along the curve; both ends of a vertical piece have one displacement.
bool isBefore(const StrokeCurve& curve, CurvePoint a, CurvePoint b) {
  if (a.displacement_mm != b.displacement_mm) return a.displacement_mm < b.displacement_mm;
  const bool rising = curve.forceBefore_N(a.displacement_mm) < curve.force_N(a.displacement_mm);
  return rising ? a.force_N < b.force_N : a.force_N > b.force_N;
}

// Returns the extremum and the nearest turns on both sides, or the ends of the range.
Hill hillAt(const StrokeCurve& curve, CurvePoint apex, double reachEnd_mm) {
  std::vector<CurvePoint> turns = curve.localMaxima();
  for (const CurvePoint& p : curve.localMinima()) turns.push_back(p);
  const Knot& first = curve.knots().front();
  Hill hill{{first.displacement_mm, first.force_N}, apex, {curve.end_mm(), curve.knots().back().force_N}};
  if (reachEnd_mm > apex.displacement_mm && reachEnd_mm < curve.end_mm())
    hill.after = {reachEnd_mm, curve.forceBefore_N(reachEnd_mm)};
  for (const CurvePoint& p : turns) {
    if (isBefore(curve, p, apex) && isBefore(curve, hill.before, p)) hill.before = p;
    if (isBefore(curve, apex, p) && isBefore(curve, p, hill.after)) hill.after = p;
  }
  return hill;
}

std::optional<Failure> hillProblem(const Hill& hill, CurvePoint to, const Message& place) {
  const auto [before, apex, after] = hill;
  // the end of a vertical piece may move along it
  const bool upVertical = to.displacement_mm == apex.displacement_mm;
  const bool between = (to.displacement_mm > before.displacement_mm ||
                        (upVertical && before.displacement_mm == apex.displacement_mm)) &&
                       (to.displacement_mm < after.displacement_mm ||
                        (upVertical && after.displacement_mm == apex.displacement_mm));
  if (!between)
    return shapeRefusal(place,
                        Message("the point cannot move to %1, because it must stay between %2 and %3",
                                millimetres(to.displacement_mm), millimetres(before.displacement_mm),
                                millimetres(after.displacement_mm)),
                        Message("Keep the point between the neighbouring peaks and valleys"));
  const bool top = apex.force_N > before.force_N || apex.force_N > after.force_N;
  const double bound =
      top ? std::max(before.force_N, after.force_N) : std::min(before.force_N, after.force_N);
  const bool stays = std::isfinite(to.force_N) && (top ? to.force_N > bound : to.force_N < bound);
  if (stays) return {};
  return shapeRefusal(place,
                      Message("with the force %1, the point would no longer be a peak or valley, because the "
                              "curve beside it ends at %2",
                              newtons(to.force_N), newtons(bound)),
                      top ? Message("Keep the force of the point above this value")
                          : Message("Keep the force of the point below this value"));
}

CurvePoint pointOf(const Knot& k) { return {k.displacement_mm, k.force_N}; }

// Maps the knots strictly between two indices and the slopes of all pieces between them.
void stretchFlank(std::vector<Knot>& knots, std::size_t first, std::size_t last, const AffineMap& map,
                  CurvePoint apex, CurvePoint to) {
  for (std::size_t i = first; i <= last; ++i) {
    Knot& k = knots[i];
    if (i > first) k.slopeBefore_N_per_mm = map.mappedSlope(k.slopeBefore_N_per_mm);
    if (i < last) k.slopeAfter_N_per_mm = map.mappedSlope(k.slopeAfter_N_per_mm);
    if (i == first || i == last) continue;
    // computed exactly, so that vertical pieces stay vertical and flat pieces flat
    k.displacement_mm =
        k.displacement_mm == apex.displacement_mm ? to.displacement_mm : map.mapped_mm(k.displacement_mm);
    k.force_N = k.force_N == apex.force_N ? to.force_N : map.mapped_N(k.force_N);
  }
}

Result<StrokeCurve> moveApex(const StrokeCurve& original, const Hill& hill, CurvePoint to,
                             const Message& place) {
  if (auto problem = hillProblem(hill, to, place)) return *problem;
  StrokeCurve curve = withExtremumKnotAt(original, hill.apex);
  curve = withKnotAt(withKnotAt(curve, hill.before.displacement_mm), hill.after.displacement_mm);
  std::vector<Knot> knots = curve.knots();
  const std::size_t before = knotAt(knots, hill.before), apex = knotAt(knots, hill.apex);
  const std::size_t after = knotAt(knots, hill.after);
  const CurvePoint was = pointOf(knots[apex]);
  const AffineMap left = flankMap(pointOf(knots[before]), was, to);
  const AffineMap right = flankMap(pointOf(knots[after]), was, to);
  stretchFlank(knots, before, apex, left, was, to);
  stretchFlank(knots, apex, after, right, was, to);
  knots[apex].displacement_mm = to.displacement_mm;
  knots[apex].force_N = to.force_N;
  return StrokeCurve::fromKnots(std::move(knots));
}

Failure noSuchTactilePoint(std::size_t index, std::size_t count) {
  return shapeRefusal("",
                      Message("the curve has no tactile point %1, because it has only %2", index + 1, count),
                      Message("Choose one of the tactile points of the curve"));
}

// ---- sections

// Shift of a section. Beside it, displacements follow linearly, so that their order is kept. Forces follow
// with a share whose slope is 0 at both ends, so that an extremum there stays one.
struct Drag {
  double left_mm, from_mm, to_mm, right_mm;  // left == from: nothing is stretched there
  double by_mm, by_N;

  // 1 in the section, decreasing linearly to 0 at the far ends of its neighbours.
  double shareOf(double x) const {
    if (x >= from_mm && x <= to_mm) return 1;
    if (x < from_mm) return x <= left_mm ? 0 : (x - left_mm) / (from_mm - left_mm);
    return x >= right_mm ? 0 : (right_mm - x) / (right_mm - to_mm);
  }
  // d share / d x between two neighbouring knots.
  double shareSlopeBetween(double a, double b) const {
    const double middle = a + 0.5 * (b - a);
    if (middle <= left_mm || middle >= right_mm || (middle >= from_mm && middle <= to_mm)) return 0;
    return middle < from_mm ? 1 / (from_mm - left_mm) : -1 / (right_mm - to_mm);
  }
  static double levelled(double share) { return share * share * (3 - 2 * share); }
  static double levelledSlope(double share) { return 6 * share * (1 - share); }
};

std::optional<Failure> dragProblem(const Drag& drag, const Message& place) {
  const auto fault = [&](double limit_mm) {
    return shapeRefusal(place,
                        Message("the section cannot move by %1, because the neighbouring section ends at %2",
                                millimetres(drag.by_mm), millimetres(limit_mm)),
                        Message("Move the section by less"));
  };
  if (drag.left_mm < drag.from_mm && !(drag.from_mm + drag.by_mm > drag.left_mm)) return fault(drag.left_mm);
  if (drag.right_mm > drag.to_mm && !(drag.to_mm + drag.by_mm < drag.right_mm)) return fault(drag.right_mm);
  return {};
}

Result<StrokeCurve> dragged(const StrokeCurve& curve, const Drag& drag) {
  const std::vector<Knot>& before = curve.knots();
  std::vector<Knot> knots = before;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    Knot& k = knots[i];
    const double x = before[i].displacement_mm, share = drag.shareOf(x);
    k.displacement_mm += share * drag.by_mm;
    k.force_N += Drag::levelled(share) * drag.by_N;
    const auto mapped = [&](double slope, double a, double b) {
      const double d = drag.shareSlopeBetween(a, b);
      return (slope + d * Drag::levelledSlope(share) * drag.by_N) / (1 + d * drag.by_mm);
    };
    if (i > 0) k.slopeBefore_N_per_mm = mapped(k.slopeBefore_N_per_mm, before[i - 1].displacement_mm, x);
    if (i + 1 < knots.size())
      k.slopeAfter_N_per_mm = mapped(k.slopeAfter_N_per_mm, x, before[i + 1].displacement_mm);
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

// ---- jumps

// Replaces all knots strictly between two displacements (which have knots) by the given ones.
std::vector<Knot> replacedBetween(const StrokeCurve& curve, double from_mm, double to_mm,
                                  const std::vector<Knot>& inside) {
  std::vector<Knot> knots;
  for (const Knot& k : curve.knots())
    if (k.displacement_mm <= from_mm) knots.push_back(k);
  knots.insert(knots.end(), inside.begin(), inside.end());
  for (const Knot& k : curve.knots())
    if (k.displacement_mm >= to_mm) knots.push_back(k);
  return knots;
}

// Replaces the curve between two displacements by a straight line.
Result<StrokeCurve> straightBetween(const StrokeCurve& original, double from_mm, double to_mm) {
  const StrokeCurve curve = withKnotAt(withKnotAt(original, from_mm), to_mm);
  std::vector<Knot> knots = replacedBetween(curve, from_mm, to_mm, {});
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    Knot &a = knots[i], &b = knots[i + 1];
    if (a.displacement_mm != from_mm || b.displacement_mm != to_mm) continue;
    a.slopeAfter_N_per_mm = b.slopeBefore_N_per_mm =
        (b.force_N - a.force_N) / (b.displacement_mm - a.displacement_mm);
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

std::optional<Failure> newJumpProblem(const StrokeCurve& curve, Stroke stroke, const NewJump& jump) {
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  if (!positive(jump.width_mm) || !positive(jump.drop_N))
    return shapeRefusal(Message("new jump"),
                        Message("the jump has the width %1 and the drop %2, but both must be above 0",
                                millimetres(jump.width_mm), newtons(jump.drop_N)),
                        Message("Give width and drop as numbers above 0"));
  const double end_mm = jump.at_mm + (stroke == Stroke::press ? jump.width_mm : -jump.width_mm);
  const auto inside = [&](double x) { return x > curve.start_mm() && x < curve.end_mm(); };
  if (!inside(jump.at_mm) || !inside(end_mm))
    return shapeRefusal(
        Message("new jump"),
        Message("the jump from %1 to %2 leaves the curve, which runs from %3 to %4", millimetres(jump.at_mm),
                millimetres(end_mm), millimetres(curve.start_mm()), millimetres(curve.end_mm())),
        Message("Make the jump narrower, or move it inward"));
  const double towards =
      stroke == Stroke::press ? curve.slopeBefore_N_per_mm(jump.at_mm) : curve.slope_N_per_mm(jump.at_mm);
  if (towards > 0) return {};
  return shapeRefusal(
      Message("new jump"),
      Message("the jump starts at %1, where the force does not rise", millimetres(jump.at_mm)),
      Message("Start the jump where the force rises, so that its start becomes a tactile point"));
}

// Returns `slope`, limited to the slopes that a monotone piece may have at its end.
double limitedSlope(double slope, double rise, double length_mm) {
  const double chord = rise / length_mm;
  if (chord == 0 || (slope < 0) != (chord < 0)) return 0;
  return std::abs(slope) > 3 * std::abs(chord) ? 3 * chord : slope;
}

}  // namespace

Result<StrokeCurve> moveTactilePoint(const StrokeCurve& curve, Stroke stroke, std::size_t index,
                                     CurvePoint to, const SectionSettings& settings) {
  const std::vector<TactilePoint> points = tactilePoints(curve, stroke, settings);
  if (index >= points.size()) return noSuchTactilePoint(index, points.size());
  const CurvePoint apex{points[index].displacement_mm, points[index].force_N};
  const Hill hill = hillAt(curve, apex, bottomOutOf(curve, settings).displacement_mm);
  return moveApex(curve, hill, to, Message("tactile point %1", index + 1));
}

Result<StrokeCurve> moveTurn(const StrokeCurve& curve, CurvePoint turn, CurvePoint to,
                             const SectionSettings& settings) {
  std::vector<CurvePoint> turns = curve.localMaxima();
  for (const CurvePoint& p : curve.localMinima()) turns.push_back(p);
  const auto place = Message("turn at %1", millimetres(turn.displacement_mm));
  if (std::find(turns.begin(), turns.end(), turn) == turns.end())
    return shapeRefusal(place, Message("the point is neither a peak nor a valley of the curve"),
                        Message("Choose a peak or a valley"));
  const double bottomOut_mm = bottomOutOf(curve, settings).displacement_mm;
  return moveApex(curve, hillAt(curve, turn, bottomOut_mm), to, place);
}

Result<StrokeCurve> setSnapRatio(const StrokeCurve& press, std::size_t tactileIndex, double ratio,
                                 const SectionSettings& settings) {
  const std::vector<TactilePoint> points = tactilePoints(press, Stroke::press, settings);
  if (tactileIndex >= points.size()) return noSuchTactilePoint(tactileIndex, points.size());
  const auto place = Message("tactile point %1", tactileIndex + 1);
  if (!std::isfinite(ratio) || ratio <= 0)
    return shapeRefusal(place, Message("a tactile point cannot have a snap ratio of %1", ratio),
                        Message("Give a ratio above 0"));
  const TactilePoint& tactile = points[tactileIndex];
  const double stop_mm =
      tactileIndex + 1 < points.size() ? points[tactileIndex + 1].displacement_mm : press.end_mm();
  std::optional<CurvePoint> valley;
  for (const CurvePoint& p : press.localMinima())
    if (p.displacement_mm > tactile.displacement_mm && p.displacement_mm < stop_mm &&
        (!valley || p.force_N < valley->force_N))
      valley = p;
  if (!valley)
    return shapeRefusal(place, Message("there is no valley after the tactile point"),
                        Message("Add a valley, or raise the end of the stroke above the tactile point"));
  const double bottomOut_mm = bottomOutOf(press, settings).displacement_mm;
  const Hill hill = hillAt(press, *valley, bottomOut_mm);
  return moveApex(press, hill, {valley->displacement_mm, tactile.force_N * (1 - ratio)},
                  Message("valley after %1", place));
}

Result<StrokeCurve> moveSection(const StrokeCurve& curve, Stroke stroke, std::size_t index, double by_mm,
                                double by_N, const SectionSettings& settings) {
  std::vector<Section> sections = sectionsOf(curve, stroke, settings);
  if (index >= sections.size())
    return shapeRefusal(
        "", Message("the curve has no section %1, because it has only %2", index + 1, sections.size()),
        Message("Choose one of the sections of the curve"));
  if (!std::isfinite(by_mm) || !std::isfinite(by_N))
    return shapeRefusal(Message("section %1", index + 1),
                        Message("the section cannot move, because the distance is not a usable number"),
                        Message("Give the distances as ordinary numbers"));
  const Section moved = sections[index];
  const auto [from_mm, to_mm] = std::minmax(moved.from_mm, moved.to_mm);
  double left_mm = from_mm, right_mm = to_mm;
  if (index > 0) (stroke == Stroke::press ? left_mm : right_mm) = sections[index - 1].from_mm;
  if (index + 1 < sections.size()) (stroke == Stroke::press ? right_mm : left_mm) = sections[index + 1].to_mm;
  const Drag drag{left_mm, from_mm, to_mm, right_mm, by_mm, by_N};
  if (auto problem = dragProblem(drag, Message("section %1", index + 1))) return *problem;
  StrokeCurve prepared = curve;
  for (double x : {left_mm, from_mm, to_mm, right_mm}) prepared = withKnotAt(prepared, x);
  return dragged(prepared, drag);
}

Result<StrokeCurve> addJump(const StrokeCurve& curve, Stroke stroke, NewJump jump) {
  if (auto problem = newJumpProblem(curve, stroke, jump)) return *problem;
  const bool press = stroke == Stroke::press;
  const double sign = press ? 1 : -1;  // sign of displacement along the stroke; the drop of a release goes up
  const double end_mm = jump.at_mm + sign * jump.width_mm;
  const auto [from_mm, to_mm] = std::minmax(jump.at_mm, end_mm);
  const StrokeCurve prepared = withKnotAt(withKnotAt(curve, from_mm), to_mm);
  const double tactile_N = curve.force_N(jump.at_mm), end_N = curve.force_N(end_mm);
  const CurvePoint valley{jump.at_mm + 0.5 * sign * jump.width_mm, tactile_N - sign * jump.drop_N};
  if (sign * (end_N - valley.force_N) <= 0)
    return shapeRefusal(
        Message("new jump"),
        Message("the jump cannot rejoin the curve: its end would lie at %1, but its valley or peak at %2",
                newtons(end_N), newtons(valley.force_N)),
        Message("Make the drop larger or the jump narrower"));
  std::vector<Knot> knots =
      replacedBetween(prepared, from_mm, to_mm, {{valley.displacement_mm, valley.force_N, 0, 0}});
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    if (knots[i].displacement_mm != valley.displacement_mm) continue;
    Knot &left = knots[i - 1], &right = knots[i + 1];
    Knot& tactile = press ? left : right;
    Knot& end = press ? right : left;
    double& leaving = press ? tactile.slopeAfter_N_per_mm : tactile.slopeBefore_N_per_mm;
    double& arriving = press ? end.slopeBefore_N_per_mm : end.slopeAfter_N_per_mm;
    leaving = 0;
    arriving =
        limitedSlope(arriving, end.force_N - valley.force_N, end.displacement_mm - valley.displacement_mm);
  }
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<StrokeCurve> removeJump(const StrokeCurve& curve, Stroke stroke, std::size_t tactileIndex,
                               const SectionSettings& settings) {
  const std::vector<TactilePoint> points = tactilePoints(curve, stroke, settings);
  if (tactileIndex >= points.size()) return noSuchTactilePoint(tactileIndex, points.size());
  const bool press = stroke == Stroke::press;
  const double tactile_mm = points[tactileIndex].displacement_mm;
  // End of the jump that begins here, even if an earlier jump contains it.
  double end_mm = press ? curve.end_mm() : curve.start_mm();
  for (const Section& s : sectionsOf(curve, stroke, settings))
    if (s.kind == SectionKind::jump && (press ? s.from_mm <= tactile_mm && tactile_mm < s.to_mm
                                              : s.from_mm >= tactile_mm && tactile_mm > s.to_mm))
      end_mm = s.to_mm;
  const double tactile_N = points[tactileIndex].force_N;
  double valley_N = tactile_N;
  for (const MonotoneStretch& s : curve.monotoneStretches())
    for (const auto& [x, force] : {std::pair{s.from_mm, s.fromForce_N}, std::pair{s.to_mm, s.toForce_N}})
      if (press ? x > tactile_mm && x <= end_mm : x < tactile_mm && x >= end_mm)
        valley_N = press ? std::min(valley_N, force) : std::max(valley_N, force);
  // Last place before the tactile point where the force has the valley's value.
  double begin_mm = press ? curve.start_mm() : curve.end_mm();
  for (double x : curve.displacementsAt(valley_N)) {
    if (press && x < tactile_mm) begin_mm = std::max(begin_mm, x);
    if (!press && x > tactile_mm) begin_mm = std::min(begin_mm, x);
  }
  return straightBetween(curve, std::min(begin_mm, end_mm), std::max(begin_mm, end_mm));
}

Result<StrokeCurve> makeLinear(const StrokeCurve& curve, const SectionSettings& settings) {
  return straightBetween(curve, curve.start_mm(), bottomOutOf(curve, settings).displacement_mm);
}

}  // namespace detent
