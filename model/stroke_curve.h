// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Force of one stroke as a function of displacement: a piecewise cubic in Hermite form with optional corners.
// Sections, tactile points and the reverse function are derived from it (sections.h).

#include <cstddef>
#include <utility>
#include <vector>

#include "model/result.h"

namespace detent {

enum class Stroke { press, release };

/// One knot of a StrokeCurve. Different slopes make a corner.
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

/// A maximal stretch over which force is monotone in displacement; constant stretches have direction 0.
struct MonotoneStretch {
  double from_mm = 0, to_mm = 0;
  double fromForce_N = 0, toForce_N = 0;
  int direction = 0;  ///< +1 rising, -1 falling, 0 flat (in increasing displacement)
};

/// Force over displacement for one stroke. Exists only if valid:
/// - 2 to maxKnots knots, everything finite;
/// - displacements never decrease; two equal displacements make a *vertical piece*: at most two knots share
///   one displacement, and the slopes inside a vertical piece are ignored;
/// - the travel is longer than 0;
/// - no piece is so steep that its slope overflows.
/// Release curves are stored like press curves, by increasing displacement. Immutable; any thread.
class StrokeCurve {
 public:
  static constexpr std::size_t maxKnots = 100000;

  /// Validates and builds. The Failure names rule, knot and value.
  static Result<StrokeCurve> fromKnots(std::vector<Knot> knots);

  /// Monotone C1 curve through points by increasing displacement (Fritsch–Carlson slopes); for templates and
  /// tests.
  static Result<StrokeCurve> throughPoints(const std::vector<CurvePoint>& points);

  const std::vector<Knot>& knots() const { return knots_; }
  double start_mm() const { return knots_.front().displacement_mm; }
  double end_mm() const { return knots_.back().displacement_mm; }
  double travel_mm() const { return end_mm() - start_mm(); }

  /// Force at a displacement. At a vertical piece the value after it; `forceBefore_N` returns the one before.
  /// Outside [start, end] the force of the nearest end.
  double force_N(double displacement_mm) const;
  double forceBefore_N(double displacement_mm) const;

  /// dF/dx from the right (`slopeBefore`: from the left); at the ends of the curve that of the only piece
  /// there. 0 outside the curve. NaN is a programming error (checked).
  double slope_N_per_mm(double displacement_mm) const;
  double slopeBefore_N_per_mm(double displacement_mm) const;

  /// Smallest and largest force (exact, from the roots of each piece's derivative).
  std::pair<double, double> forceRange_N() const;

  /// All displacements with this force, increasing; a constant stretch contributes its two ends.
  std::vector<double> displacementsAt(double force_N) const;

  /// All local extrema inside the curve by increasing displacement; of a flat top, its middle.
  std::vector<CurvePoint> localMaxima() const;
  std::vector<CurvePoint> localMinima() const;

  /// Monotone stretches by increasing displacement, touching. Vertical pieces (from_mm == to_mm) and flat
  /// stretches are separate; all other neighbours have opposite directions. A turn below rounding is ignored.
  std::vector<MonotoneStretch> monotoneStretches() const;

  /// Displacement inside a monotone stretch at a force between its ends (clamped). Exact to 1 ulp of travel
  /// (bracketed Newton). Of a vertical or flat stretch: from_mm. The stretch must come from this curve
  /// (checked).
  double displacementIn(const MonotoneStretch& stretch, double force_N) const;

  /// Integral of force over displacement (N·mm = mJ); exact; signed (from > to: negative). Outside the curve
  /// the integrand is 0.
  double area_mJ(double from_mm, double to_mm) const { return areaAbove_mJ(0, from_mm, to_mm); }

  /// Integral of force minus a level, without cancellation where the curve is close to the level.
  double areaAbove_mJ(double level_N, double from_mm, double to_mm) const;

  friend bool operator==(const StrokeCurve&, const StrokeCurve&) = default;

 private:
  explicit StrokeCurve(std::vector<Knot> knots) : knots_(std::move(knots)) {}
  std::size_t pieceFrom(
      double displacement_mm) const;                  // the non-vertical piece to the right of a displacement
  std::size_t pieceTo(double displacement_mm) const;  // the non-vertical piece to the left of a displacement
  std::vector<Knot> knots_;
};

}  // namespace detent
