// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of single knots.
#include <algorithm>
#include <cmath>

#include "model/edits.h"

namespace detent {
namespace {

Failure knotRefusal(Message place, Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, "stroke curve", std::move(place), std::move(problem), std::move(remedies)};
}

std::optional<Failure> noSuchKnot(const StrokeCurve& curve, std::size_t index) {
  if (index < curve.knots().size()) return {};
  return knotRefusal(
      "",
      Message("the curve has no point %1, because it has only %2 points", index + 1, curve.knots().size()),
      Message("Choose one of the points of the curve"));
}

using KnotEdit = std::function<void(Knot&)>;

Result<StrokeCurve> editKnot(const StrokeCurve& curve, std::size_t index, const KnotEdit& edit) {
  if (auto problem = noSuchKnot(curve, index)) return *problem;
  std::vector<Knot> knots = curve.knots();
  edit(knots[index]);
  return StrokeCurve::fromKnots(std::move(knots));
}

// Slope of the chord between two knots; nullopt for a vertical piece.
std::optional<double> chordSlope(const Knot& a, const Knot& b) {
  if (a.displacement_mm == b.displacement_mm) return {};
  return (b.force_N - a.force_N) / (b.displacement_mm - a.displacement_mm);
}

struct Chords {
  std::optional<double> before, after;
  double lengthBefore_mm = 0, lengthAfter_mm = 0;
};

Chords chordsAt(const std::vector<Knot>& knots, std::size_t index) {
  Chords chords;
  if (index > 0) {
    chords.before = chordSlope(knots[index - 1], knots[index]);
    chords.lengthBefore_mm = knots[index].displacement_mm - knots[index - 1].displacement_mm;
  }
  if (index + 1 < knots.size()) {
    chords.after = chordSlope(knots[index], knots[index + 1]);
    chords.lengthAfter_mm = knots[index + 1].displacement_mm - knots[index].displacement_mm;
  }
  return chords;
}

// Fritsch and Carlson's monotone slope between two chords: their weighted harmonic mean, 0 if their signs
// differ.
double smoothSlope(const Chords& chords) {
  if (!chords.before || !chords.after) return chords.before.value_or(chords.after.value_or(0));
  const double before = *chords.before, after = *chords.after;
  if (before == 0 || after == 0 || (before < 0) != (after < 0)) return 0;
  const double w0 = 2 * chords.lengthAfter_mm + chords.lengthBefore_mm;
  const double w1 = chords.lengthAfter_mm + 2 * chords.lengthBefore_mm;
  const double slope = (w0 + w1) / (w0 / before + w1 / after);
  return std::isfinite(slope) ? slope : 0;
}

// True if the piece between two knots only rises, only falls, or is level: Fritsch and Carlson's condition.
bool isMonotone(const Knot& a, const Knot& b) {
  const double chord = chordSlope(a, b).value_or(0), from = a.slopeAfter_N_per_mm,
               to = b.slopeBefore_N_per_mm;
  if (a.displacement_mm == b.displacement_mm) return true;
  if (chord == 0) return from == 0 && to == 0;
  const double first = from / chord, last = to / chord, twice = 2 * first + last - 3;
  if (first < 0 || last < 0) return false;
  if (first + last <= 2 || twice <= 0 || first + 2 * last <= 3) return true;
  return first - twice * twice / (3 * (first + last - 2)) >= 0;
}

// Limits slopes so that pieces which were monotone before the knots moved are monotone after it. Smooth knots
// stay smooth. Slopes only get nearer to 0.
void keepMonotone(const std::vector<Knot>& old, std::vector<Knot>& knots) {
  constexpr double steepest = 3;  // times the slope of the chord: up to this ratio every cubic is monotone
  const auto limited = [](double slope, double chord) {
    return std::clamp(slope, std::min(0.0, steepest * chord), std::max(0.0, steepest * chord));
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 1; i < knots.size(); ++i) {
      if (isMonotone(knots[i - 1], knots[i]) || !isMonotone(old[i - 1], old[i])) continue;
      const double chord = *chordSlope(knots[i - 1], knots[i]);
      for (Knot* knot : {&knots[i - 1], &knots[i]}) {
        const bool smooth = knot->slopeBefore_N_per_mm == knot->slopeAfter_N_per_mm;
        double& slope = knot == &knots[i] ? knot->slopeBefore_N_per_mm : knot->slopeAfter_N_per_mm;
        slope = limited(slope, chord);
        if (smooth) knot->slopeBefore_N_per_mm = knot->slopeAfter_N_per_mm = slope;
      }
      changed = isMonotone(knots[i - 1], knots[i]) || changed;
    }
  }
}

}  // namespace

Result<StrokeCurve> moveKnot(const StrokeCurve& curve, std::size_t index, CurvePoint to) {
  if (auto problem = noSuchKnot(curve, index)) return *problem;
  const std::vector<Knot>& knots = curve.knots();
  const bool passesBefore = index > 0 && to.displacement_mm < knots[index - 1].displacement_mm;
  const bool passesAfter = index + 1 < knots.size() && to.displacement_mm > knots[index + 1].displacement_mm;
  if (passesBefore || passesAfter) {
    const Knot& neighbour = knots[passesBefore ? index - 1 : index + 1];
    return knotRefusal(Message("curve point %1", index + 1),
                       Message("the point cannot move to %1, because its neighbour at %2 lies in between",
                               millimetres(to.displacement_mm), millimetres(neighbour.displacement_mm)),
                       Message("Keep the point between its neighbours, or remove the neighbour first"));
  }
  return placeKnots(curve, {{index, to}});
}

Result<StrokeCurve> setSlopeBefore(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm) {
  return editKnot(curve, index, [&](Knot& k) { k.slopeBefore_N_per_mm = slope_N_per_mm; });
}

Result<StrokeCurve> setSlopeAfter(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm) {
  return editKnot(curve, index, [&](Knot& k) { k.slopeAfter_N_per_mm = slope_N_per_mm; });
}

Result<StrokeCurve> setSlope(const StrokeCurve& curve, std::size_t index, double slope_N_per_mm) {
  return editKnot(curve, index,
                  [&](Knot& k) { k.slopeBefore_N_per_mm = k.slopeAfter_N_per_mm = slope_N_per_mm; });
}

Result<StrokeCurve> makeCorner(const StrokeCurve& curve, std::size_t index) {
  if (auto problem = noSuchKnot(curve, index)) return *problem;
  const Chords chords = chordsAt(curve.knots(), index);
  return editKnot(curve, index, [&](Knot& k) {
    k.slopeBefore_N_per_mm = chords.before.value_or(k.slopeBefore_N_per_mm);
    k.slopeAfter_N_per_mm = chords.after.value_or(k.slopeAfter_N_per_mm);
  });
}

Result<StrokeCurve> makeSmooth(const StrokeCurve& curve, std::size_t index) {
  if (auto problem = noSuchKnot(curve, index)) return *problem;
  return setSlope(curve, index, smoothSlope(chordsAt(curve.knots(), index)));
}

bool isCorner(const StrokeCurve& curve, std::size_t index) {
  const std::vector<Knot>& knots = curve.knots();
  if (index == 0 || index + 1 >= knots.size()) return false;
  const Chords chords = chordsAt(knots, index);
  if (!chords.before || !chords.after) return true;  // the end of a vertical piece
  return knots[index].slopeBefore_N_per_mm != knots[index].slopeAfter_N_per_mm;
}

Result<StrokeCurve> insertKnot(const StrokeCurve& curve, double displacement_mm) {
  if (!(displacement_mm > curve.start_mm() && displacement_mm < curve.end_mm()))
    return knotRefusal(
        "",
        Message("no point can be added at %1, because the curve runs from %2 to %3",
                millimetres(displacement_mm), millimetres(curve.start_mm()), millimetres(curve.end_mm())),
        Message("Choose a displacement between the ends of the curve"));
  std::vector<Knot> knots = curve.knots();
  auto after = knots.begin();
  while (after->displacement_mm < displacement_mm) ++after;
  if (after->displacement_mm == displacement_mm)
    return knotRefusal(Message("curve point %1", after - knots.begin() + 1),
                       Message("there already is a curve point at %1", millimetres(displacement_mm)),
                       Message("Move that curve point instead"));
  const double slope = curve.slope_N_per_mm(displacement_mm);
  knots.insert(after, {displacement_mm, curve.force_N(displacement_mm), slope, slope});
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<StrokeCurve> removeKnot(const StrokeCurve& curve, std::size_t index) {
  if (auto problem = noSuchKnot(curve, index)) return *problem;
  if (curve.knots().size() == 2)
    return knotRefusal(Message("curve point %1", index + 1),
                       Message("the point cannot be removed, because a curve needs 2 points"),
                       Message("Move the point instead"));
  std::vector<Knot> knots = curve.knots();
  knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(index));
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<StrokeCurve> placeKnots(const StrokeCurve& curve, const std::vector<KnotPlace>& positions) {
  std::vector<Knot> knots = curve.knots();
  for (const KnotPlace& place : positions) {
    if (auto problem = noSuchKnot(curve, place.index)) return *problem;
    knots[place.index].displacement_mm = place.to.displacement_mm;
    knots[place.index].force_N = place.to.force_N;
  }
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (!(knots[i].displacement_mm < knots[i - 1].displacement_mm)) continue;
    return knotRefusal(
        Message("curve point %1", i + 1),
        Message("the point would move to %1, before curve point %2 at %3",
                millimetres(knots[i].displacement_mm), i, millimetres(knots[i - 1].displacement_mm)),
        Message("Keep the points in their order, or select fewer points"));
  }
  keepMonotone(curve.knots(), knots);
  return StrokeCurve::fromKnots(std::move(knots));
}

Result<StrokeCurve> removeKnots(const StrokeCurve& curve, const std::vector<std::size_t>& indices) {
  std::vector<bool> goes(curve.knots().size(), false);
  for (const std::size_t index : indices) {
    if (auto problem = noSuchKnot(curve, index)) return *problem;
    goes[index] = true;
  }
  std::vector<Knot> left;
  for (std::size_t i = 0; i < goes.size(); ++i)
    if (!goes[i]) left.push_back(curve.knots()[i]);
  if (left.size() < 2)
    return knotRefusal("",
                       Message("%1 points cannot be removed, because a curve needs 2 points",
                               curve.knots().size() - left.size()),
                       Message("Keep at least two points"));
  return StrokeCurve::fromKnots(std::move(left));
}

Result<std::vector<Knot>> stretchOf(const StrokeCurve& curve, double from_mm, double to_mm) {
  if (!(from_mm < to_mm && from_mm >= curve.start_mm() && to_mm <= curve.end_mm()))
    return knotRefusal(
        "", Message("the curve has no part from %1 to %2", millimetres(from_mm), millimetres(to_mm)),
        Message("Choose two places on the curve, the first one before the second"));
  StrokeCurve cut = curve;
  for (const double end_mm : {from_mm, to_mm}) {
    const auto& knots = cut.knots();
    if (std::any_of(knots.begin(), knots.end(), [&](const Knot& k) { return k.displacement_mm == end_mm; }))
      continue;
    auto with = insertKnot(cut, end_mm);
    if (!with) return with.failure();
    cut = *std::move(with);
  }
  std::vector<Knot> stretch;
  for (const Knot& k : cut.knots())
    if (k.displacement_mm >= from_mm && k.displacement_mm <= to_mm) stretch.push_back(k);
  return stretch;
}

Result<StrokeCurve> putStretch(const StrokeCurve& curve, const std::vector<Knot>& stretch) {
  if (stretch.empty())
    return knotRefusal("", Message("there are no points to insert into the curve"),
                       Message("Give one point or more"));
  const double from_mm = stretch.front().displacement_mm, to_mm = stretch.back().displacement_mm;
  std::vector<Knot> knots;
  for (const Knot& k : curve.knots())
    if (k.displacement_mm < from_mm) knots.push_back(k);
  knots.insert(knots.end(), stretch.begin(), stretch.end());
  for (const Knot& k : curve.knots())
    if (k.displacement_mm > to_mm) knots.push_back(k);
  return StrokeCurve::fromKnots(std::move(knots));
}

}  // namespace detent
