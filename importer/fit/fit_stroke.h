#pragma once
// Step 6: from dense points of one stroke to a StrokeCurve with as few pieces as the evidence supports.

#include <string>
#include <vector>

#include "model/sections.h"
#include "model/stroke_curve.h"

namespace detent::importer {

/// Noise of the points along each axis: the yardstick of the orthogonal distance.
struct PointNoise {
  double sigma_mm = 0;  ///< > 0
  double sigma_N = 0;   ///< > 0
};

enum class PieceCriterion { bic, fixed };

struct FitOptions {
  PointNoise noise;                 ///< required
  PieceCriterion criterion = PieceCriterion::bic;
  int pieces = 0;                   ///< for `fixed`: how many; >= 1
  int maxPieces = 64;               ///< 1..2000
  double robustScale = 3;           ///< residuals beyond this many sigmas count linearly; > 0
  double tolerance = 1e-8;          ///< relative cost change that ends the solver; (0, 1e-2]; finer ones are derived from it
  int maxPoints = 2000;             ///< longer strokes are thinned to this many by arc length before fitting; >= 4
};

/// A tactile point with standard errors from the covariance of the fit.
struct FittedTactilePoint {
  TactilePoint point;
  double sigma_mm = 0;
  double sigma_N = 0;
};

enum class FitOutcome { converged, iterationLimit, tooFewPoints };

struct FitSummary {
  FitOutcome outcome = FitOutcome::converged;
  int pieces = 0;
  int points = 0;
  double rmsSigma = 0;              ///< rms orthogonal residual in sigmas
  double maxSigma = 0;
  double bic = 0;
  double seconds = 0;
  std::vector<FittedTactilePoint> tactilePoints;
  std::string brief() const;        ///< one line
  bool usable() const { return outcome != FitOutcome::tooFewPoints; }
};

struct FittedStroke {
  StrokeCurve curve;
  FitSummary summary;
};

/// Points in the order travelled. Deterministic. Failure unreadableInput: fewer than 2 distinct points, not finite, no travel.
Result<FittedStroke> fitStroke(const std::vector<CurvePoint>& points, Stroke stroke, const FitOptions& options);

}  // namespace detent::importer
