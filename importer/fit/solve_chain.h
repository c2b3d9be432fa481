// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Moves the knots of a chain to the least robust orthogonal distance, by Levenberg–Marquardt with analytic
// Jacobians.

#include "importer/fit/knot_chain.h"

namespace detent::importer {

struct SolveSettings {
  double robustScale = 3;   ///< sigmas; residuals beyond it count linearly (Huber)
  double tolerance = 1e-8;  ///< relative cost change
  int maxIterations = 30;   ///< per assignment of points to pieces
  int associations = 2;     ///< number of assignments of points to pieces; >= 1
};

/// Knots [from, to) may move; other knots and pieces stay.
struct KnotRange {
  std::size_t from = 0, to = 0;
};

/// Moves the knots in `range`. Displacements keep their order: a knot may move half the way to its neighbours
/// per assignment, so a leaning bottom-out ends exactly vertical. An end in a bottom-out keeps its force, any
/// other end its displacement. Returns false if the iteration limit was reached.
bool solveChain(KnotChain& chain, const std::vector<SigmaPoint>& points, KnotRange range,
                const SolveSettings& settings);

/// Robust chi-square of all points on the current chain.
double chiSquareOf(const KnotChain& chain, const std::vector<SigmaPoint>& points, double robustScale);

struct KnotSigma {
  double u = 0, v = 0;  ///< standard errors; 0 for a fixed coordinate
};

struct KnotErrors {
  std::vector<KnotSigma> sigmas;  ///< per knot
  /// Condition number of the Jacobian with columns scaled to length 1 (van der Sluis 1969): the ratio of the
  /// worst to the best determined combination of knots. 1 to 1e8, because it is computed from J'J.
  double condition = 1;
};

/// Standard errors of all knots from the covariance of the whole fit, all knots free, with the residuals as
/// they are (White 1980). Shared errors are not included: multiply by the root of correlationPoints.
KnotErrors knotErrors(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                      const SolveSettings& settings);

}  // namespace detent::importer
