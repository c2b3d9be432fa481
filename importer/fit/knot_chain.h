// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The curve during the fit: knots in sigmas (stroke_samples.h), pieces that cannot overshoot.

#include <array>
#include <cstddef>
#include <vector>

#include "importer/fit/stroke_samples.h"

namespace detent::importer {

/// Parameters of a knot: u, v, slope before, slope after. A smooth knot uses the first slope on both sides.
using KnotParameters = std::array<double, 4>;

/// Kind of a joint; decides which parameters are free.
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

/// Number of free parameters of an inner joint.
int freedomOf(JointKind joint);

using KnotChain = std::vector<ChainKnot>;

/// Replaces displacements that decrease (a leaning bottom-out, noise) by their mean: a vertical piece.
void levelDisplacements(KnotChain& chain);

/// Removes redundant knots: repeated places, and those inside a vertical piece.
void dropRedundantKnots(KnotChain& chain);

/// One piece as a curve over t in [0, 1]: u = u0 + h t, v = v0 + a t + (3d - 2a - b) t^2 + (a + b - 2d) t^3.
/// The end tangents a and b are limited to 0..3d, so the piece is monotone for any knots (Fritsch & Carlson
/// 1980); written over t it stays finite at h = 0 (vertical).
struct ChainPiece {
  double u0 = 0, h = 0, v0 = 0, d = 0, a = 0, b = 0;
  bool aFree = false, bFree = false;  ///< true if the slope acts on the tangent, false if the limit does
  double aPerD = 0, bPerD = 0;        ///< tangent / d at a limit: 0 or 3; 1 in a vertical piece

  ChainPiece(const ChainKnot& from, const ChainKnot& to);

  double startSlope() const { return h > 0 ? a / h : 0; }  ///< 0 in a vertical piece
  double endSlope() const { return h > 0 ? b / h : 0; }
  double u(double t) const { return u0 + h * t; }
  double v(double t) const { return v0 + t * (a + t * (c2 + t * c3)); }
  double dv(double t) const { return a + t * (2 * c2 + 3 * t * c3); }
  double ddv(double t) const { return 2 * c2 + 6 * t * c3; }

 private:
  double c2 = 0, c3 = 0;
};

/// Nearest place on a piece to a point.
struct Footpoint {
  std::size_t piece = 0;
  double t = 0;
  double squaredDistance = 0;
};

/// Nearest place on one piece, by Newton steps from `t` within [0, 1].
Footpoint nearestFrom(const ChainPiece& piece, const SigmaPoint& point, double t);

/// Nearest place on one piece without a start value.
Footpoint nearestOn(const ChainPiece& piece, const SigmaPoint& point);

std::vector<ChainPiece> piecesOf(const KnotChain& chain);

/// Nearest places of all points on the chain.
std::vector<Footpoint> footpointsOn(const KnotChain& chain, const std::vector<SigmaPoint>& points);

/// Signed weighted distance: positive above the curve (or right of a vertical piece).
double signedResidual(const ChainPiece& piece, const SigmaPoint& point, double t);

}  // namespace detent::importer
