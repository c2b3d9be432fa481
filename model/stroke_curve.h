// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The force of one stroke as a function of displacement: a piecewise cubic in Hermite form, corners allowed.
// Everything about sections, tactile points and the reverse function is derived from it (sections.h).

#include <cstddef>
#include <utility>
#include <vector>

#include "model/result.h"

namespace detent {

enum class Stroke { press, release };

/// One joint of a StrokeCurve. Where the two slopes differ the curve has a corner.
struct Knot {
  double displacement_mm = 0;
  double force_N = 0;
  double slopeBefore_N_per_mm =
      0;  ///< slope of the piece that ends here (ignored at the first knot, kept as given)
  double slopeAfter_N_per_mm = 0;  ///< slope of the piece that starts here (ignored at the last knot)

  friend bool operator==(const Knot&, const Knot&) = default;
};

/// A root, extremum or crossing on a curve.
struct CurvePoint {
  double displacement_mm = 0;
  double force_N = 0;
  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// A maximal stretch over which force is monotone in displacement (constant stretches are their own,
/// direction 0).
struct MonotoneStretch {
  double from_mm = 0, to_mm = 0;
  double fromForce_N = 0, toForce_N = 0;
  int direction = 0;  ///< +1 rising, -1 falling, 0 flat (in increasing displacement)
};

/// Force over displacement for one stroke. Exists only if valid:
///  - 2 to maxKnots knots, everything finite;
///  - displacements never decrease; equal displacements make a *vertical piece* (a wall): at most two knots
///    share one displacement, and the slopes on the inside of a vertical piece are ignored;
///  - the whole travel is longer than 0;
///  - no piece is so steep that its slope leaves the range of a double.
/// Release curves are stored like press curves, by increasing displacement; who travels them backwards says
/// so. Immutable value; any thread.
class StrokeCurve {
 public:
  static constexpr std::size_t maxKnots = 100000;

  /// Validates and builds. Failure names the rule, the knot and the value.
  static Result<StrokeCurve> fromKnots(std::vector<Knot> knots);

  /// Monotone-safe C1 curve through points by increasing displacement (Fritsch–Carlson slopes); for templates
  /// and tests.
  static Result<StrokeCurve> throughPoints(const std::vector<CurvePoint>& points);

  const std::vector<Knot>& knots() const { return knots_; }
  double start_mm() const { return knots_.front().displacement_mm; }
  double end_mm() const { return knots_.back().displacement_mm; }
  double travel_mm() const { return end_mm() - start_mm(); }

  /// Force at a displacement. At a wall the value after it; `forceBefore_N` gives the one before.
  /// Outside [start, end] the nearest end's force: a curve says nothing there.
  double force_N(double displacement_mm) const;
  double forceBefore_N(double displacement_mm) const;

  /// dF/dx, from the right (`slopeBefore` from the left); at the two ends of the curve that of the only piece
  /// there, beside a wall that of the piece on the asked side of it. 0 outside the curve. NaN is a bug of the
  /// caller (checked).
  double slope_N_per_mm(double displacement_mm) const;
  double slopeBefore_N_per_mm(double displacement_mm) const;

  /// Smallest and largest force (exact, from the roots of each piece's derivative).
  std::pair<double, double> forceRange_N() const;

  /// All displacements where the curve has this force, increasing; a stretch that lies on it gives its two
  /// ends.
  std::vector<double> displacementsAt(double force_N) const;

  /// All local extrema inside the curve, increasing displacement; of a flat top, its middle.
  std::vector<CurvePoint> localMaxima() const;
  std::vector<CurvePoint> localMinima() const;

  /// The curve cut into monotone stretches, in increasing displacement, touching; each wall stands alone
  /// (from_mm == to_mm), as does each flat; all other neighbours have opposite directions. A turn whose
  /// height is below the rounding of the forces around it is none.
  std::vector<MonotoneStretch> monotoneStretches() const;

  /// Displacement inside a monotone stretch at a force between its ends (clamped to them). Exact to 1 ulp of
  /// travel (bracketed Newton). Of a wall or a flat: from_mm. The stretch must come from this curve
  /// (checked).
  double displacementIn(const MonotoneStretch& stretch, double force_N) const;

  /// Integral of force over displacement (N·mm = mJ) between two displacements; exact; signed (from > to:
  /// negative). What lies outside the curve adds nothing.
  double area_mJ(double from_mm, double to_mm) const { return areaAbove_mJ(0, from_mm, to_mm); }

  /// The same for force minus a level: no cancellation where the curve lies close to the level.
  double areaAbove_mJ(double level_N, double from_mm, double to_mm) const;

  friend bool operator==(const StrokeCurve&, const StrokeCurve&) = default;

 private:
  explicit StrokeCurve(std::vector<Knot> knots) : knots_(std::move(knots)) {}
  std::size_t pieceFrom(
      double displacement_mm) const;                  // the non-vertical piece to the right of a displacement
  std::size_t pieceTo(double displacement_mm) const;  // the non-vertical piece to the left of it
  std::vector<Knot> knots_;
};

}  // namespace detent
