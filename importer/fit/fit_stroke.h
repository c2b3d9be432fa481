// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 6: from dense points of one stroke to a StrokeCurve with as few pieces as the evidence supports.
// In:  points in the order travelled (a traced line, a force meter's log), the noise of the points, FitOptions.
// Out: the curve and a FitSummary; or a Failure.
// Reading order: stroke_samples.h (order, thinning, yardstick) -> segment_stroke.h (first knots) ->
//                knot_chain.h (the curve being fitted) -> solve_chain.h (least distance,
//                band_matrix.h) -> choose_knots.h (evidence).

#include <cstddef>
#include <string>
#include <vector>

#include "importer/fit/fit_options.h"
#include "model/sections.h"
#include "model/stroke_curve.h"

namespace detent::importer {

/// A tactile point with standard errors from the covariance of the fit.
struct FittedTactilePoint {
  TactilePoint point;
  double sigma_mm = 0;
  double sigma_N = 0;
};

enum class FitOutcome {
  converged,
  iterationLimit,  ///< usable; the solver stopped before its tolerance
  tooFewPoints     ///< the points alone do not determine a fit: they are joined by straight pieces
};

struct FitSummary {
  FitOutcome outcome = FitOutcome::converged;
  int pieces = 0;
  int points = 0;       ///< points used, after thinning
  double rmsSigma = 0;  ///< rms orthogonal distance of the points, in sigmas of the given noise
  double maxSigma = 0;
  double correlationPoints = 1;  ///< points that share one error, >= 1; standard errors take it into account
  double condition = 1;          ///< of the fit (KnotErrors), 1 to 1e8; 1 where points were only joined
  double bic = 0;
  double seconds = 0;
  std::vector<FittedTactilePoint> tactilePoints;
  std::string brief() const;  ///< one line
};

struct FittedStroke {
  StrokeCurve curve;
  FitSummary summary;
};

/// Points in the order travelled (press: towards larger displacement; release: back). Points given the other
/// way round are turned. Every piece of the curve is monotone; extrema stand at knots; the ends of the curve
/// are the ends of the points. Deterministic. Any thread. Failure unreadableInput: fewer than 2 distinct
/// points, not finite, no travel, points that run to and fro; wrongUsage: options outside their ranges.
Result<FittedStroke> fitStroke(const std::vector<CurvePoint>& points, Stroke stroke,
                               const FitOptions& options);

}  // namespace detent::importer
