// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// First knots of a stroke: optimal cutting into cubics by dynamic programming.

#include "importer/fit/knot_chain.h"

namespace detent::importer {

struct Segmentation {
  KnotChain chain;               ///< at least 2 knots, u never decreasing, ends at the ends of the points
  double correlationPoints = 1;  ///< number of neighbouring residuals that share one error, >= 1
};

/// Cuts the points into runs where v is a function of u, and steep runs where u is a function of v. Each run
/// is cut into cubics that minimise chi-square + `penalty` per piece over all cuts at `candidates` places
/// (Bellman 1961).
Segmentation segmentStroke(const std::vector<SigmaPoint>& points, int candidates, double penalty);

/// Number of neighbouring residuals that share one error: their integrated autocorrelation with outliers
/// clipped; 1 if independent.
double correlationOf(std::vector<double> residuals);

}  // namespace detent::importer
