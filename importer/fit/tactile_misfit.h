// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the fit's covariance cannot know: how far a tactile point lies from where the points around it put it, because a curve
// of few cubics is no more than what the evidence paid for.

#include "importer/fit/knot_chain.h"

namespace detent::importer {

/// Distance of a tactile point of the chain from the mean of several local models of the points around it, each as likely as its
/// evidence says, the chain's own pieces among them (Hoeting et al. 1999; docs/develop/decisions/0204-errors-of-tactile-points.md).
struct TactileMisfit {
  double u = 0, v = 0;  ///< sigmas, signed: model mean - chain
};

/// `at`: the chain's extremum nearest to a tactile point; `sign`: 1 for a press, -1 for a release; `correlationPoints` >= 1:
/// points that share one error. Zero where too few points lie around it to tell.
TactileMisfit tactileMisfit(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                            const ChainKnot& at, double sign, double correlationPoints);

}  // namespace detent::importer
