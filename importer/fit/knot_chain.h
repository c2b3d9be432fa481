// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The curve while it is being fitted: knots in sigmas (stroke_samples.h), pieces that cannot overshoot.

#include <array>
#include <cstddef>
#include <vector>

#include "importer/fit/stroke_samples.h"

namespace detent::importer {

/// A knot as the solver moves it: u, v, slope before, slope after. A smooth knot uses its first slope on both
/// sides.
using KnotParameters = std::array<double, 4>;

/// What kind of joint a knot is; decides which of its parameters are free.
enum class JointKind {
  smooth,  ///< one slope: u, v, slope
  corner,  ///< two slopes: u, v, slope before, slope after
  flat     ///< an extremum with slope 0: u, v
};

struct ChainKnot {
  KnotParameters at{};
  JointKind joint = JointKind::smooth;

  double u() const { return at[0]; }
  double v() const { return at[1]; }
  double slopeBefore() const { return joint == JointKind::flat ? 0 : at[2]; }
  double slopeAfter() const { return joint == JointKind::flat ? 0 : at[joint == JointKind::corner ? 3 : 2]; }
};

/// Free parameters of a joint inside the curve.
int freedomOf(JointKind joint);

using KnotChain = std::vector<ChainKnot>;

/// Displacements that run backwards (a wall that leans back, noise) are levelled to their mean: a vertical
/// piece.
void levelDisplacements(KnotChain& chain);

/// Takes out knots that say nothing: repeated places, and those inside a vertical piece (two knots make it).
void dropRedundantKnots(KnotChain& chain);

/// One piece as a curve over t in [0, 1]: u = u0 + h t, v = v0 + a t + (3d - 2a - b) t^2 + (a + b - 2d) t^3.
/// The end tangents a and b are kept between 0 and 3d, which makes the piece monotone for any knots
/// (Fritsch & Carlson 1980); written over t it stays finite where h = 0, at a wall.
struct ChainPiece {
  double u0 = 0, h = 0, v0 = 0, d = 0, a = 0, b = 0;
  bool aFree = false, bFree = false;  ///< the slope acts on the tangent; else the limit holds it
  double aPerD = 0, bPerD = 0;        ///< tangent / d where a limit holds it: 0 or 3; 1 in a wall

  ChainPiece(const ChainKnot& from, const ChainKnot& to);

  double startSlope() const { return h > 0 ? a / h : 0; }  ///< 0 in a wall
  double endSlope() const { return h > 0 ? b / h : 0; }
  double u(double t) const { return u0 + h * t; }
  double v(double t) const { return v0 + t * (a + t * (c2 + t * c3)); }
  double dv(double t) const { return a + t * (2 * c2 + 3 * t * c3); }
  double ddv(double t) const { return 2 * c2 + 6 * t * c3; }

 private:
  double c2 = 0, c3 = 0;
};

/// Nearest place of a piece to a point.
struct Footpoint {
  std::size_t piece = 0;
  double t = 0;
  double squaredDistance = 0;
};

/// Nearest place on one piece, by a few Newton steps from `t` kept inside [0, 1].
Footpoint nearestFrom(const ChainPiece& piece, const SigmaPoint& point, double t);

/// Nearest place on one piece without a hint.
Footpoint nearestOn(const ChainPiece& piece, const SigmaPoint& point);

std::vector<ChainPiece> piecesOf(const KnotChain& chain);

/// Nearest places of all points on the whole chain.
std::vector<Footpoint> footpointsOn(const KnotChain& chain, const std::vector<SigmaPoint>& points);

/// Signed weighted distance: positive above (or, at a wall, right of) the curve.
double signedResidual(const ChainPiece& piece, const SigmaPoint& point, double t);

}  // namespace detent::importer
