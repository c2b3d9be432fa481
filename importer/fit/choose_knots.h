// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Chooses the number and kind of knots: removes, adds and smooths knots by evidence.

#include "importer/fit/solve_chain.h"

namespace detent::importer {

/// Price of a parameter in chi-square (Schwarz 1978). Neighbouring points share their error, so
/// `correlationPoints` of them count once (Bartlett 1935).
struct KnotEvidence {
  double correlationPoints = 1;  ///< >= 1
  double pricePerParameter = 7;  ///< ln of the number of independent points

  KnotEvidence(double points, double correlation);

  /// Lower is better.
  double score(double chiSquare, int parameters) const {
    return chiSquare / correlationPoints + pricePerParameter * parameters;
  }
  /// The same price in chi-square.
  double chiSquarePer(int parameters) const { return pricePerParameter * parameters * correlationPoints; }
};

/// Number of free parameters of a chain.
int parametersOf(const KnotChain& chain);

/// Signed weighted residuals of all points, in their order.
std::vector<double> residualsOf(const KnotChain& chain, const std::vector<SigmaPoint>& points);

struct ChoiceSettings {
  int rounds = 2;
  int maxPieces = 64;
  SolveSettings solve;  ///< settings of the local solves around a changed knot
};

/// Removes knots and corners whose parameters cost more than they gain, and adds those that gain more than
/// they cost. Each change is judged by a solve of the knots around it; then all knots are solved. Return
/// value: as of solveChain.
bool chooseKnots(KnotChain& chain, const std::vector<SigmaPoint>& points, const KnotEvidence& evidence,
                 const ChoiceSettings& settings);

/// Removes the least useful knots, or adds the most useful, until there are `pieces` pieces, if possible.
/// Return value: as of solveChain.
bool reachPieces(KnotChain& chain, const std::vector<SigmaPoint>& points, int pieces,
                 const ChoiceSettings& settings);

/// Fallback for a diverged solve (a few outliers leave a knot undetermined): moves knots farther than `reach`
/// sigmas from the line through the points back to it, ends to the points' ends. Returns the number of moved
/// knots.
int returnStrayKnots(KnotChain& chain, const std::vector<SigmaPoint>& points, double reach);

}  // namespace detent::importer
