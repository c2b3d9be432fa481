// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Options of a fit: noise of its points and effort.

namespace detent::importer {

/// Noise of the points along each axis, used to scale orthogonal distances. Traced lines: about 0.3 px in mm
/// and in N. Force logs: the estimates of ForceLog.
struct PointNoise {
  double sigma_mm = 0;  ///< > 0
  double sigma_N = 0;   ///< > 0
};

/// Criterion for the number of pieces.
enum class PieceCriterion {
  bic,   ///< least chi-square + parameters * ln(points), where points that share one error count as one
  fixed  ///< exactly FitOptions::pieces, or fewer if there are too few points
};

/// Effort of a fit; one per quality level of the importer.
enum class FitEffort { draft, standard, precise };

struct FitOptions {
  PointNoise noise;  ///< required
  PieceCriterion criterion = PieceCriterion::bic;
  int pieces = 0;          ///< for `fixed`: number of pieces; >= 1
  int maxPieces = 64;      ///< 1..2000
  double robustScale = 3;  ///< residuals beyond this many sigmas count linearly; > 0
  double tolerance =
      1e-6;  ///< relative cost change that ends the solver; (0, 1e-2]; finer ones are derived from it
  int maxPoints = 2000;  ///< longer strokes are thinned to this number of points by arc length; >= 4
  double resolutionOfSpan =
      1.5e-3;  ///< deviations below this share of an axis span are not modelled; in [0, 0.1]
  /// Noise at a tactile point as a share of `noise`, in (0, 1]. Traces are closer to the line there than
  /// their stated noise, which covers crossings; a tester's noise is the same everywhere.
  double noiseAtTactilePoints_share = 1;
  double correlationPoints = 0;  ///< number of points that share one error; 0: estimated from the residuals;
                                 ///< else >= 1
  int candidateKnots = 200;      ///< candidate places of knots in the first segmentation; 8..2000
  int evidenceRounds = 2;        ///< rounds of removing, adding and smoothing knots; 0..20
};

/// Options of the three levels (figures: docs/develop/decisions/0200-choosing-knots.md).
FitOptions fitOptionsFor(FitEffort effort, PointNoise noise);

}  // namespace detent::importer
