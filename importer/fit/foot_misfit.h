// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The foot of a bottom-out as the points around it have it: few cubics round a corner off.

#include <optional>

#include "importer/fit/knot_chain.h"

namespace detent::importer {

/// Where a bend below and a bend of the wall meet in a corner.
struct CornerFoot {
  double u = 0, v = 0;
  double slopeBefore = 0, slopeAfter = 0;
  double likely = 0;  ///< 0..1: by its evidence against the chain's own pieces, as for tactile points (0204)
  double wallFrom_v = 0;  ///< the wall's own points begin here
};

/// `foot`: the chain's knot where its wall begins, not an end. Empty where too few points lie around it to tell.
std::optional<CornerFoot> cornerFoot(const KnotChain& chain, const std::vector<SigmaPoint>& points,
                                     std::size_t foot, double correlationPoints);

/// The chain with that corner in the place of its foot.
KnotChain withCorner(const KnotChain& chain, const CornerFoot& corner, std::size_t foot);

}  // namespace detent::importer
