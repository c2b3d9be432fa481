// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/stroke_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "model/check.h"

namespace detent {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Failure curveFailure(Message place, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, "stroke curve", std::move(place), std::move(problem),
          std::move(remedies)};
}

Message knotPlace(std::size_t index) { return Message("curve point %1", index + 1); }

// One non-vertical piece over u = (x - x0)/h in [0, 1]. Tangents are slopes times h, so nothing is divided by
// a small h.
struct Piece {
  double start_mm, length_mm;
  double forceStart, forceEnd;      // N
  double tangentStart, tangentEnd;  // N per unit u

  double rise() const { return forceEnd - forceStart; }
  double quadratic() const { return 3 * rise() - 2 * tangentStart - tangentEnd; }
  double cubic() const { return tangentStart + tangentEnd - 2 * rise(); }

  // Evaluated from the nearer end, so that both knots are met exactly.
  double force(double u) const {
    if (u <= 0.5) return forceStart + u * (tangentStart + u * (quadratic() + u * cubic()));
    const double v = 1 - u;
    const double quadraticBack = -3 * rise() + 2 * tangentEnd + tangentStart;
    return forceEnd - v * (tangentEnd - v * (quadraticBack - v * (tangentStart + tangentEnd - 2 * rise())));
  }
  double forcePerU(double u) const { return tangentStart + u * (2 * quadratic() + u * 3 * cubic()); }
  double displacement(double u) const { return u >= 1 ? start_mm + length_mm : start_mm + u * length_mm; }
  bool flat() const { return forceStart == forceEnd && tangentStart == 0 && tangentEnd == 0; }

  // Size of the terms whose rounding limits the significance of a turn.
  double magnitude() const {
    return std::max({std::abs(forceStart), std::abs(forceEnd), std::abs(tangentStart), std::abs(tangentEnd)});
  }
};

Piece pieceOf(const std::vector<Knot>& knots, std::size_t index) {
  const Knot& a = knots[index];
  const Knot& b = knots[index + 1];
  const double length = b.displacement_mm - a.displacement_mm;
  return {a.displacement_mm,
          length,
          a.force_N,
          b.force_N,
          a.slopeAfter_N_per_mm * length,
          b.slopeBefore_N_per_mm * length};
}

bool isVertical(const std::vector<Knot>& knots, std::size_t index) {
  return knots[index].displacement_mm == knots[index + 1].displacement_mm;
}

// Real roots of c + b u + a u^2 strictly inside (0, 1), increasing, by the closed forms without cancellation.
struct Roots {
  std::array<double, 2> at{};
  int count = 0;
  void addInside(double u) {
    if (u > 0 && u < 1) at[static_cast<std::size_t>(count++)] = u;
  }
};

Roots quadraticRootsInside(double a, double b, double c) {
  Roots roots;
  const double scale = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (scale == 0) return roots;
  a /= scale;
  b /= scale;
  c /= scale;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return roots;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0) return roots;  // b = c = 0 (double root at u = 0) or b = 0 = a*c: no root inside
  roots.addInside(c / q);
  if (a != 0 && q / a != c / q) roots.addInside(q / a);
  if (roots.count == 2 && roots.at[0] > roots.at[1]) std::swap(roots.at[0], roots.at[1]);
  return roots;
}

// Derivative roots that separate rising from falling by more than rounding.
Roots pieceTurns(const Piece& piece) {
  Roots candidates = quadraticRootsInside(3 * piece.cubic(), 2 * piece.quadratic(), piece.tangentStart);
  const double noise = 4 * epsilon * piece.magnitude();
  // Drop the root with the smallest step until every step is significant and directions alternate.
  while (candidates.count > 0) {
    std::array<double, 4> force{};
    const auto n = static_cast<std::size_t>(candidates.count);
    force[0] = piece.forceStart;
    for (std::size_t i = 0; i < n; ++i) force[i + 1] = piece.force(candidates.at[i]);
    force[n + 1] = piece.forceEnd;
    std::size_t smallest = 0;
    for (std::size_t i = 1; i <= n; ++i)
      if (std::abs(force[i + 1] - force[i]) < std::abs(force[smallest + 1] - force[smallest])) smallest = i;
    std::size_t drop = n;
    if (std::abs(force[smallest + 1] - force[smallest]) <= noise) {
      drop = smallest == 0 ? 0 : smallest - 1;
      if (n == 2 && smallest == 1) return {};  // two turns that cancel: an inflection
    } else {
      for (std::size_t i = 0; i < n && drop == n; ++i)
        if ((force[i + 1] > force[i]) == (force[i + 2] > force[i + 1])) drop = i;
    }
    if (drop == n) return candidates;
    for (std::size_t i = drop; i + 1 < n; ++i) candidates.at[i] = candidates.at[i + 1];
    --candidates.count;
  }
  return candidates;
}

int directionOf(double from, double to) { return to > from ? 1 : to < from ? -1 : 0; }

void appendStretch(std::vector<MonotoneStretch>& stretches, const MonotoneStretch& next) {
  if (next.from_mm == next.to_mm && next.direction == 0) return;  // a doubled knot has no length
  if (!stretches.empty()) {
    MonotoneStretch& last = stretches.back();
    const bool bothExtended = last.from_mm < last.to_mm && next.from_mm < next.to_mm;
    if (bothExtended && last.direction == next.direction) {
      last.to_mm = next.to_mm;
      last.toForce_N = next.toForce_N;
      return;
    }
  }
  stretches.push_back(next);
}

// Returns u in [low, high] where the monotone piece has the force; force(low) and force(high) enclose it.
double solveMonotone(const Piece& piece, double low, double high, double force, double tolerance) {
  double lowValue = piece.force(low) - force;
  const double highValue = piece.force(high) - force;
  if (lowValue == 0) return low;
  if (highValue == 0) return high;
  if ((lowValue < 0) == (highValue < 0)) return std::abs(lowValue) < std::abs(highValue) ? low : high;
  double u = low + (high - low) * (lowValue / (lowValue - highValue));
  for (int iteration = 0; iteration < 200 && high - low > tolerance; ++iteration) {
    if (!(u > low && u < high)) u = low + 0.5 * (high - low);
    if (u == low || u == high) break;
    const double value = piece.force(u) - force;
    if (value == 0) return u;
    const double width = high - low;
    if ((value < 0) == (lowValue < 0)) {
      low = u;
      lowValue = value;
    } else {
      high = u;
    }
    const double slope = piece.forcePerU(u);
    const double newton = slope != 0 ? u - value / slope : low - 1;
    const bool shrinksWell = high - low < 0.75 * width;
    if (std::abs(newton - u) < tolerance && newton >= low && newton <= high) return newton;
    u = (newton > low && newton < high && (shrinksWell || iteration % 2 == 0)) ? newton
                                                                               : low + 0.5 * (high - low);
  }
  return low + 0.5 * (high - low);
}

std::optional<Failure> knotProblem(const std::vector<Knot>& knots, std::size_t i) {
  const Knot& k = knots[i];
  const std::array<std::pair<const char*, double>, 4> values{{{"displacement", k.displacement_mm},
                                                              {"force", k.force_N},
                                                              {"slope before", k.slopeBefore_N_per_mm},
                                                              {"slope after", k.slopeAfter_N_per_mm}}};
  for (const auto& [name, value] : values)
    if (!std::isfinite(value))
      return curveFailure(knotPlace(i), Message("%1 is %2, not a usable number", name, value),
                          Message("Give every curve point usable numbers"));
  if (i == 0) return {};
  const double before = knots[i - 1].displacement_mm;
  if (k.displacement_mm < before)
    return curveFailure(knotPlace(i),
                        Message("the displacement %1 lies before that of the previous point, %2",
                                millimetres(k.displacement_mm), millimetres(before)),
                        Message("Sort the points by increasing displacement"));
  if (i >= 2 && k.displacement_mm == knots[i - 2].displacement_mm)
    return curveFailure(
        knotPlace(i),
        Message("this is the third point at the displacement %1", millimetres(k.displacement_mm)),
        Message("At one displacement, keep at most two points: the ends of a vertical piece"));
  return {};
}

std::optional<Failure> pieceProblem(const std::vector<Knot>& knots, std::size_t i) {
  const bool vertical = isVertical(knots, i);
  const double rise = knots[i + 1].force_N - knots[i].force_N;
  double steepest = rise;
  if (!vertical) {
    const double length = knots[i + 1].displacement_mm - knots[i].displacement_mm;
    steepest = 6 * (std::abs(rise) / length) +
               6 * (std::abs(knots[i].slopeAfter_N_per_mm) + std::abs(knots[i + 1].slopeBefore_N_per_mm));
    if (length > 1) steepest *= length;  // the tangents over the piece must stay finite too
  }
  if (std::isfinite(steepest)) return {};
  return curveFailure(Message("piece %1", i + 1), Message("this piece is too steep to compute its slope"),
                      Message("Make the piece vertical (equal displacements) or less steep"));
}

// Three-point end slope of a monotone curve (Fritsch and Butland).
double endSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

double innerSlope(double h0, double h1, double d0, double d1) {
  if (d0 == 0 || d1 == 0 || (d0 < 0) != (d1 < 0)) return 0;
  const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

// Sets the slopes of strictly increasing points [first, last].
void setSlopes(std::vector<Knot>& knots, std::size_t first, std::size_t last) {
  const auto length = [&](std::size_t i) { return knots[i + 1].displacement_mm - knots[i].displacement_mm; };
  const auto secant = [&](std::size_t i) { return (knots[i + 1].force_N - knots[i].force_N) / length(i); };
  const auto set = [&](std::size_t i, double slope) {
    if (!std::isfinite(slope)) slope = 0;
    knots[i].slopeBefore_N_per_mm = knots[i].slopeAfter_N_per_mm = slope;
  };
  if (first == last) return set(first, 0);
  if (last == first + 1) {
    set(first, secant(first));
    return set(last, secant(first));
  }
  for (std::size_t i = first + 1; i < last; ++i)
    set(i, innerSlope(length(i - 1), length(i), secant(i - 1), secant(i)));
  set(first, endSlope(length(first), length(first + 1), secant(first), secant(first + 1)));
  set(last, endSlope(length(last - 1), length(last - 2), secant(last - 1), secant(last - 2)));
}

struct CompensatedSum {
  double sum = 0, lost = 0;
  void add(double value) {
    const double next = sum + value;
    lost += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
    sum = next;
  }
  double value() const { return sum + lost; }
};

std::vector<CurvePoint> turnsInto(const std::vector<MonotoneStretch>& stretches, int direction) {
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
    if (stretches[i].direction != direction) continue;
    std::size_t next = i + 1;
    while (next < stretches.size() && stretches[next].direction == 0) ++next;
    if (next == stretches.size() || stretches[next].direction != -direction) continue;
    const double from = stretches[i].to_mm, to = stretches[next].from_mm;
    points.push_back({std::midpoint(from, to), stretches[i].toForce_N});
  }
  return points;
}

}  // namespace

Result<StrokeCurve> StrokeCurve::fromKnots(std::vector<Knot> knots) {
  if (knots.size() < 2)
    return curveFailure("", Message("the curve has %1 points, but it needs at least 2", knots.size()),
                        Message("Give at least the start and the end of the curve"));
  if (knots.size() > maxKnots)
    return curveFailure(
        "", Message("the curve has %1 points, but at most %2 are allowed", knots.size(), maxKnots),
        Message("Remove some of the points first"));
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (auto problem = knotProblem(knots, i)) return *problem;
  if (!(knots.back().displacement_mm > knots.front().displacement_mm))
    return curveFailure("",
                        Message("the curve has no travel, because all its points lie at %1",
                                millimetres(knots.front().displacement_mm)),
                        Message("Give the curve two different displacements"));
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    if (auto problem = pieceProblem(knots, i)) return *problem;
  return StrokeCurve(std::move(knots));
}

Result<StrokeCurve> StrokeCurve::throughPoints(const std::vector<CurvePoint>& points) {
  std::vector<Knot> knots;
  knots.reserve(points.size());
  for (const CurvePoint& p : points) knots.push_back({p.displacement_mm, p.force_N, 0, 0});
  if (auto valid = fromKnots(knots); !valid) return valid;
  for (std::size_t first = 0; first < knots.size();) {
    std::size_t last = first;
    while (last + 1 < knots.size() && !isVertical(knots, last)) ++last;
    setSlopes(knots, first, last);
    first = last + 1;
  }
  return fromKnots(std::move(knots));
}

std::size_t StrokeCurve::pieceFrom(double displacement_mm) const {
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), displacement_mm,
                                      [](double x, const Knot& k) { return x < k.displacement_mm; });
  DETENT_CHECK(after != knots_.begin() && after != knots_.end(), "displacement inside [start, end)");
  return static_cast<std::size_t>(after - knots_.begin()) - 1;
}

std::size_t StrokeCurve::pieceTo(double displacement_mm) const {
  const auto at = std::lower_bound(knots_.begin(), knots_.end(), displacement_mm,
                                   [](const Knot& k, double x) { return k.displacement_mm < x; });
  DETENT_CHECK(at != knots_.begin() && at != knots_.end(), "displacement inside (start, end]");
  return static_cast<std::size_t>(at - knots_.begin()) - 1;
}

double StrokeCurve::force_N(double displacement_mm) const {
  DETENT_CHECK(!std::isnan(displacement_mm), "displacement is a number");
  if (displacement_mm < start_mm()) return knots_.front().force_N;
  if (displacement_mm >= end_mm()) return knots_.back().force_N;
  const Piece piece = pieceOf(knots_, pieceFrom(displacement_mm));
  return piece.force((displacement_mm - piece.start_mm) / piece.length_mm);
}

double StrokeCurve::forceBefore_N(double displacement_mm) const {
  DETENT_CHECK(!std::isnan(displacement_mm), "displacement is a number");
  if (displacement_mm <= start_mm()) return knots_.front().force_N;
  if (displacement_mm > end_mm()) return knots_.back().force_N;
  const Piece piece = pieceOf(knots_, pieceTo(displacement_mm));
  return piece.force((displacement_mm - piece.start_mm) / piece.length_mm);
}

double StrokeCurve::slope_N_per_mm(double displacement_mm) const {
  DETENT_CHECK(!std::isnan(displacement_mm), "displacement is a number");
  if (displacement_mm < start_mm() || displacement_mm > end_mm()) return 0;
  const std::size_t index =
      displacement_mm < end_mm() ? pieceFrom(displacement_mm) : pieceTo(displacement_mm);
  if (knots_[index].displacement_mm == displacement_mm) return knots_[index].slopeAfter_N_per_mm;
  if (knots_[index + 1].displacement_mm == displacement_mm) return knots_[index + 1].slopeBefore_N_per_mm;
  const Piece piece = pieceOf(knots_, index);
  return piece.forcePerU((displacement_mm - piece.start_mm) / piece.length_mm) / piece.length_mm;
}

double StrokeCurve::slopeBefore_N_per_mm(double displacement_mm) const {
  DETENT_CHECK(!std::isnan(displacement_mm), "displacement is a number");
  if (displacement_mm < start_mm() || displacement_mm > end_mm()) return 0;
  const std::size_t index =
      displacement_mm > start_mm() ? pieceTo(displacement_mm) : pieceFrom(displacement_mm);
  if (knots_[index + 1].displacement_mm == displacement_mm) return knots_[index + 1].slopeBefore_N_per_mm;
  if (knots_[index].displacement_mm == displacement_mm) return knots_[index].slopeAfter_N_per_mm;
  const Piece piece = pieceOf(knots_, index);
  return piece.forcePerU((displacement_mm - piece.start_mm) / piece.length_mm) / piece.length_mm;
}

std::pair<double, double> StrokeCurve::forceRange_N() const {
  double low = knots_.front().force_N, high = low;
  const auto include = [&](double force) {
    low = std::min(low, force);
    high = std::max(high, force);
  };
  for (const Knot& k : knots_) include(k.force_N);
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    if (isVertical(knots_, i)) continue;
    const Piece piece = pieceOf(knots_, i);
    const Roots turns = pieceTurns(piece);
    for (int t = 0; t < turns.count; ++t) include(piece.force(turns.at[static_cast<std::size_t>(t)]));
  }
  return {low, high};
}

std::vector<MonotoneStretch> StrokeCurve::monotoneStretches() const {
  std::vector<MonotoneStretch> stretches;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const double from_mm = knots_[i].displacement_mm, fromForce = knots_[i].force_N;
    const double to_mm = knots_[i + 1].displacement_mm, toForce = knots_[i + 1].force_N;
    if (isVertical(knots_, i)) {
      appendStretch(stretches, {from_mm, to_mm, fromForce, toForce, directionOf(fromForce, toForce)});
      continue;
    }
    const Piece piece = pieceOf(knots_, i);
    double cut_mm = from_mm, cutForce = fromForce;
    const Roots turns = pieceTurns(piece);
    for (int t = 0; t < turns.count; ++t) {
      const double u = turns.at[static_cast<std::size_t>(t)];
      const double turn_mm = piece.displacement(u), turnForce = piece.force(u);
      // the piece is shorter than the resolution of doubles
      if (turn_mm <= cut_mm || turn_mm >= to_mm) continue;
      appendStretch(stretches, {cut_mm, turn_mm, cutForce, turnForce, directionOf(cutForce, turnForce)});
      cut_mm = turn_mm;
      cutForce = turnForce;
    }
    appendStretch(stretches, {cut_mm, to_mm, cutForce, toForce, directionOf(cutForce, toForce)});
  }
  return stretches;
}

std::vector<CurvePoint> StrokeCurve::localMaxima() const { return turnsInto(monotoneStretches(), 1); }

std::vector<CurvePoint> StrokeCurve::localMinima() const { return turnsInto(monotoneStretches(), -1); }

double StrokeCurve::displacementIn(const MonotoneStretch& stretch, double force_N) const {
  DETENT_CHECK(!std::isnan(force_N), "force is a number");
  DETENT_CHECK(stretch.from_mm >= start_mm() && stretch.to_mm <= end_mm() && stretch.from_mm <= stretch.to_mm,
               "stretch of this curve");
  if (stretch.direction == 0 || stretch.from_mm == stretch.to_mm) return stretch.from_mm;
  const double sign = stretch.direction;
  if (sign * force_N <= sign * stretch.fromForce_N) return stretch.from_mm;
  if (sign * force_N >= sign * stretch.toForce_N) return stretch.to_mm;
  // Knots inside the stretch are monotone in force, so the piece is found by bisection.
  std::size_t low = pieceFrom(stretch.from_mm), high = pieceTo(stretch.to_mm);
  while (low < high) {
    const std::size_t middle = low + (high - low + 1) / 2;
    if (sign * knots_[middle].force_N <= sign * force_N)
      low = middle;
    else
      high = middle - 1;
  }
  const Piece piece = pieceOf(knots_, low);
  const double from = std::max(0.0, (stretch.from_mm - piece.start_mm) / piece.length_mm);
  const double to = std::min(1.0, (stretch.to_mm - piece.start_mm) / piece.length_mm);
  const double tolerance = 0.5 * epsilon * std::min(1.0, travel_mm() / piece.length_mm);
  const double u = solveMonotone(piece, from, to, force_N, tolerance);
  return std::clamp(piece.displacement(u), stretch.from_mm, stretch.to_mm);
}

std::vector<double> StrokeCurve::displacementsAt(double force_N) const {
  std::vector<double> found;
  const auto add = [&](double x) {
    if (found.empty() || found.back() != x) found.push_back(x);
  };
  for (const MonotoneStretch& stretch : monotoneStretches()) {
    const auto [low, high] = std::minmax(stretch.fromForce_N, stretch.toForce_N);
    if (!(force_N >= low && force_N <= high)) continue;
    add(displacementIn(stretch, force_N));
    if (stretch.direction == 0) add(stretch.to_mm);
  }
  return found;
}

double StrokeCurve::areaAbove_mJ(double level_N, double from_mm, double to_mm) const {
  DETENT_CHECK(!std::isnan(from_mm) && !std::isnan(to_mm) && std::isfinite(level_N), "limits are numbers");
  if (from_mm > to_mm) return -areaAbove_mJ(level_N, to_mm, from_mm);
  const double low = std::max(from_mm, start_mm()), high = std::min(to_mm, end_mm());
  if (!(low < high)) return 0;
  CompensatedSum area;
  const std::size_t last = pieceTo(high);
  for (std::size_t i = pieceFrom(low); i <= last; ++i) {
    if (isVertical(knots_, i)) continue;
    const Piece piece = pieceOf(knots_, i);
    const double a = std::max(0.0, (low - piece.start_mm) / piece.length_mm);
    const double b = std::min(1.0, (high - piece.start_mm) / piece.length_mm);
    const double middle = a + 0.5 * (b - a);
    // Simpson's rule is exact for cubics.
    const double sum =
        (piece.force(a) - level_N) + 4 * (piece.force(middle) - level_N) + (piece.force(b) - level_N);
    area.add((b - a) * piece.length_mm / 6 * sum);
  }
  return area.value();
}

}  // namespace detent
