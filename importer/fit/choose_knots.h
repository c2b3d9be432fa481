// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How many knots the points support, and of which kind: knots are taken out, added and rounded off by
// evidence.

#include "importer/fit/solve_chain.h"

namespace detent::importer {

/// What chi-square is worth and what a parameter must earn (Schwarz 1978). Neighbouring points share their
/// error, so `correlationPoints` of them count once (Bartlett 1935).
struct Evidence {
  double correlationPoints = 1;  ///< >= 1
  double pricePerParameter = 7;  ///< ln of the number of independent points

  Evidence(double points, double correlation);

  /// Lower is better.
  double score(double chiSquare, int parameters) const {
    return chiSquare / correlationPoints + pricePerParameter * parameters;
  }
  /// The same price in chi-square.
  double chiSquarePer(int parameters) const { return pricePerParameter * parameters * correlationPoints; }
};

/// Free parameters of a chain.
int parametersOf(const KnotChain& chain);

/// Signed weighted residuals of all points, in their order.
std::vector<double> residualsOf(const KnotChain& chain, const std::vector<SigmaPoint>& points);

struct ChoiceSettings {
  int rounds = 2;
  int maxPieces = 64;
  SolveSettings solve;  ///< of the local solves around a changed knot
};

/// Takes out knots that do not earn their parameters, makes corners smooth that do not earn theirs, adds
/// knots and corners where the residuals pay for them. Each change is judged by a solve of the knots around
/// it; then all knots are solved. False: as solveChain.
bool chooseKnots(KnotChain& chain, const std::vector<SigmaPoint>& points, const Evidence& evidence,
                 const ChoiceSettings& settings);

/// Takes out the least useful knots until `pieces` are left; or adds the most useful until there are as many,
/// if it can. False: as solveChain.
bool reachPieces(KnotChain& chain, const std::vector<SigmaPoint>& points, int pieces,
                 const ChoiceSettings& settings);

/// The last word against a solve that went astray (a few wild points leave a knot undetermined): knots
/// further than `reach` sigmas from the line through the points go back to it, ends to the points' ends. Returns how many did.
int returnStrayKnots(KnotChain& chain, const std::vector<SigmaPoint>& points, double reach);

}  // namespace detent::importer
