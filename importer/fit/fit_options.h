// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a fit is told: how noisy its points are, and how much work it may spend on them.

namespace detent::importer {

/// Noise of the points along each axis: the yardstick of the orthogonal distance.
/// Traced lines: about 0.3 px in mm and in N. Force logs: the estimates of ForceLog.
struct PointNoise {
  double sigma_mm = 0;  ///< > 0
  double sigma_N = 0;   ///< > 0
};

/// How the number of pieces is found.
enum class PieceCriterion {
  bic,   ///< chi-square + parameters * ln(points), both counted in independent points (residuals are
         ///< correlated)
  fixed  ///< exactly FitOptions::pieces, or fewer where the points are too few
};

/// How much work a fit may spend; the importer's quality levels map onto it one to one.
enum class FitEffort { draft, standard, precise };

struct FitOptions {
  PointNoise noise;  ///< required
  PieceCriterion criterion = PieceCriterion::bic;
  int pieces = 0;          ///< for `fixed`: how many; >= 1
  int maxPieces = 64;      ///< 1..2000
  double robustScale = 3;  ///< residuals beyond this many sigmas count linearly; > 0
  double tolerance =
      1e-6;  ///< relative cost change that ends the solver; (0, 1e-2]; finer ones are derived from it
  int maxPoints = 2000;  ///< longer strokes are thinned to this many by arc length before fitting; >= 4
  double resolutionOfSpan =
      1.5e-3;  ///< deviations below this share of an axis' span are not modelled; in [0, 0.1]
  /// What remains of the noise at the top of a tactile point, as a share of `noise`. Traces lie closer to the
  /// line there than their stated noise, which has to cover crossings; a meter's noise is the same
  /// everywhere. In (0, 1].
  double noiseAtTactilePoints_share = 1;
  double correlationPoints = 0;  ///< points that share one error; 0: estimated from the residuals; else >= 1
  int candidateKnots = 200;      ///< places at which the first segmentation may put a knot; 8..2000
  int evidenceRounds = 2;        ///< rounds of taking out, adding and rounding off knots; 0..20
};

/// Settings of the three levels (figures: docs/develop/decisions/0200-choosing-knots.md).
FitOptions fitOptionsFor(FitEffort effort, PointNoise noise);

}  // namespace detent::importer
