#pragma once
// How many knots the points support, and of which kind: knots are taken out, added and rounded off by
// evidence.

#include "importer/fit/solve_chain.h"

namespace detent::importer {

/// What an additional parameter must earn in chi-square, and what chi-square is worth: residuals that share
/// one error count once (effective number of points, Bartlett 1935).
struct Evidence {
  double correlationPoints = 1;  ///< points that share one error, >= 1
  double pricePerParameter = 7;  ///< ln of the effective number of points

  /// Lower is better.
  double score(double chiSquare, int parameters) const {
    return chiSquare / correlationPoints + pricePerParameter * parameters;
  }
};

/// Free parameters of a chain with fixed ends.
int parametersOf(const KnotChain& chain);

/// Points that share one error, from the decay of the residuals' autocorrelation; 1 for independent ones.
double correlationOf(const KnotChain& chain, const std::vector<SigmaPoint>& points);

}  // namespace detent::importer
