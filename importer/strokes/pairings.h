// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The ways in which curves may belong together compete: each pair, each press alone and each mark carries
// evidence, and the set that covers all curves with the most evidence wins.
// docs/develop/decisions/0701-several-switches.md

#include <cstddef>
#include <optional>
#include <vector>

#include "importer/evidence/evidence.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer {

/// One switch: a pair of traces in their order, or a press alone.
struct Pairing {
  std::size_t trace = 0;
  std::optional<std::size_t> other = {};
  Evidence evidence = {};  ///< for one switch, against a switch for each of its traces
  double margin = 0;       ///< evidence of the whole set less that of the best one without this switch
};

/// The switches with the most evidence among all traces of two points or more; marks are left out. Empty if a
/// curve can be neither a switch's nor a mark.
std::vector<Pairing> bestPairings(const std::vector<CurveTrace>& traces);

/// Least confidence with which curves belong together.
inline constexpr double leastSure = 0.5;

/// Confidence in a pairing, 0..1: none without a margin to its best rival, or if it is no switch itself.
double confidenceOf(const Pairing& pairing);

}  // namespace detent::importer
