// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Moves the knots of a chain: least robust orthogonal distance, by Levenberg and Marquardt with analytic Jacobians.

#include "importer/fit/knot_chain.h"

namespace detent::importer {

struct SolveSettings {
  double robustScale = 3;   ///< sigmas; residuals beyond it count linearly (Huber)
  double tolerance = 1e-8;  ///< relative cost change
  int maxIterations = 30;   ///< per association of points and pieces
  int associations = 2;     ///< how often points are assigned to pieces anew; >= 1
};

/// Knots [from, to) may move; the others, and what lies outside the pieces that touch them, stay as they are.
struct KnotRange {
  std::size_t from = 0, to = 0;
};

/// Moves the knots in `range`. Displacements keep their order: a knot may go half the way to its neighbours
/// per association, so a wall that would lean back ends exactly vertical. Ends keep the points' ends: an end
/// in a wall keeps its force, any other end its displacement. False: the limit of iterations ended it.
bool solveChain(KnotChain& chain, const std::vector<SigmaPoint>& points, KnotRange range,
                const SolveSettings& settings);

/// Robust chi-square of all points on the chain as it stands.
double chiSquareOf(const KnotChain& chain, const std::vector<SigmaPoint>& points, double robustScale);

struct KnotSigma {
  double u = 0, v = 0;  ///< standard errors; 0 where a coordinate is held
};

struct KnotErrors {
  std::vector<KnotSigma> sigmas;  ///< per knot
  /// Of the whole fit's Jacobian, its columns scaled to length 1, which no scaling betters by more than the root of
  /// their number (van der Sluis 1969): how much less is known of the worst combination of knots than of the
  /// best. 1 to 1e8: it is taken from J'J, whose least eigenvalue is rounding beyond.
  double condition = 1;
};

/// Standard errors of all knots' places from the covariance of the whole fit, all knots free. Weights differ
/// from the scatter of the points (resolution, averaging), so the covariance takes the residuals as they are
/// (White 1980); residuals that share one error are not its business: the caller multiplies by the root of
/// their number.
KnotErrors knotErrors(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                      const SolveSettings& settings);

}  // namespace detent::importer
