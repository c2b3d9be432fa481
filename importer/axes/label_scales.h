// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// All scales that a row of evenly spaced labels may have, independent of what is read there.

#include <cstddef>
#include <string>
#include <vector>

namespace detent::importer {

/// numbers of labels in a row that is read by its scale
inline constexpr std::size_t fewestLabels = 3, mostLabels = 12;

/// A candidate scale: the value of each label, and how common such a scale is.
struct LabelScale {
  std::vector<std::string> texts;
  double prior = 0;             ///< logarithm of the prior probability (nats), <= 0
  double step = 0, lowest = 0;  ///< difference of neighbouring labels, and the smallest value

  /// True if the scales differ only in zeros behind the decimal point.
  bool sameValues(const LabelScale& other) const { return step == other.step && lowest == other.lowest; }
};

/// The positions as whole numbers of steps from the first; empty if they are not evenly spaced.
std::vector<int> evenSteps(const std::vector<double>& centers_px);

/// All scales whose step is a round number and that begin at zero or a multiple of the step. `rising`: values
/// grow with the position.
std::vector<LabelScale> scalesOf(std::vector<int> steps, bool rising);

}  // namespace detent::importer
