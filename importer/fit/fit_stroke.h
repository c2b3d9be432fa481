// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Step 6: from dense points of one stroke to a StrokeCurve with as few pieces as the evidence supports. In:
// points in the order travelled (a traced line, a tester's log), their noise, FitOptions. Out: the curve and
// a FitSummary, or a Failure. Reading order: stroke_samples.h (order, thinning, scaling) -> segment_stroke.h
// (first knots) -> knot_chain.h (the curve being fitted) -> solve_chain.h (least distance, band_matrix.h) ->
// choose_knots.h (evidence).

#include <cstddef>
#include <string>
#include <vector>

#include "importer/fit/fit_options.h"
#include "model/sections.h"
#include "model/stroke_curve.h"

namespace detent::importer {

/// A tactile point with standard errors of the fit.
struct FittedTactilePoint {
  TactilePoint point;
  double sigma_mm = 0;
  double sigma_N = 0;
};

enum class FitOutcome {
  converged,
  iterationLimit,  ///< usable; the solver stopped before its tolerance
  tooFewPoints     ///< too few points for a fit; they are joined by straight pieces
};

struct FitSummary {
  FitOutcome outcome = FitOutcome::converged;
  int pieces = 0;
  int points = 0;       ///< points used, after thinning
  double rmsSigma = 0;  ///< rms orthogonal distance of the points, in sigmas of the given noise
  double maxSigma = 0;
  double correlationPoints = 1;  ///< number of points that share one error, >= 1; included in the standard
                                 ///< errors
  double condition = 1;          ///< condition number of the fit (KnotErrors), 1 to 1e8; 1 if points were
                                 ///< only joined
  double bic = 0;
  double seconds = 0;
  std::vector<FittedTactilePoint> tactilePoints;
  std::string brief() const;  ///< one line
};

struct FittedStroke {
  StrokeCurve curve;
  FitSummary summary;
};

/// Fits a curve to points in the order travelled (press: towards larger displacement; release: back);
/// reversed points are turned. Every piece is monotone, extrema lie on knots, and the ends are the ends of
/// the points. Deterministic. Any thread. Failure unreadableInput: fewer than 2 distinct points, not finite,
/// no travel, points that run to and fro; wrongUsage: options outside their ranges.
Result<FittedStroke> fitStroke(const std::vector<CurvePoint>& points, Stroke stroke,
                               const FitOptions& options);

}  // namespace detent::importer
