// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Misfit of a tactile point: its distance from where the points around it put it. The fit's covariance does
// not include it, because the fit has few pieces.

#include "importer/fit/knot_chain.h"

namespace detent::importer {

/// Distance of a tactile point of the chain from the mean of several local models of the points around it,
/// weighted by their evidence; the chain's own pieces are one model (Hoeting et al. 1999;
/// docs/develop/decisions/0204-errors-of-tactile-points.md).
struct TactileMisfit {
  double u = 0, v = 0;  ///< sigmas, signed: model mean - chain
};

/// `at`: the chain's extremum nearest to a tactile point; `sign`: 1 for a press, -1 for a release;
/// `correlationPoints` >= 1: points that share one error. Zero if there are too few points around it.
TactileMisfit tactileMisfit(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                            const ChainKnot& at, double sign, double correlationPoints);

}  // namespace detent::importer
