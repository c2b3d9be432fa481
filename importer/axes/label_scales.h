// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scales that a row of labels in even steps may stand on, whatever is read in it.

#include <cstddef>
#include <string>
#include <vector>

namespace detent::importer {

inline constexpr std::size_t fewestLabels = 3, mostLabels = 12;  ///< of a row that is read by its scale

/// A scale the labels may stand on: value of each, and how usual it is.
struct LabelScale {
  std::vector<std::string> texts;
  double prior = 0;             ///< nats, <= 0
  double step = 0, lowest = 0;  ///< from label to label, and the smallest value

  /// Zeros behind the point or none: the same numbers.
  bool sameValues(const LabelScale& other) const { return step == other.step && lowest == other.lowest; }
};

/// Places as whole steps from the first; empty if they are not even.
std::vector<int> evenSteps(const std::vector<double>& centers_px);

/// All scales of nice steps from zero or a multiple of the step. `rising`: values grow with the place.
std::vector<LabelScale> scalesOf(std::vector<int> steps, bool rising);

}  // namespace detent::importer
