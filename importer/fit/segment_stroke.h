#pragma once
// The first knots of a stroke: optimal cutting into cubics by dynamic programming.

#include "importer/fit/knot_chain.h"

namespace detent::importer {

/// Cuts the points into runs where v is a function of u and steep runs where u is a function of v (walls),
/// each run into cubics that minimise chi-square + `penalty` per piece over all cuts at `candidates` places
/// (Bellman 1961). At least 2 knots, u never decreasing, ends at the ends of the points.
KnotChain segmentStroke(const std::vector<SigmaPoint>& points, int candidates, double penalty);

}  // namespace detent::importer
