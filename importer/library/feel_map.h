// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Places switches on a map whose distances match the felt distances of the switches as closely as two
// dimensions allow.

#include <array>
#include <optional>
#include <vector>

#include "importer/library/library_switch.h"

namespace detent::importer {

/// One principal axis of the differences between switches.
struct FeelAxis {
  double share = 0;  ///< of the variance that lies along it, 0..1
  /// the key figure with the largest correlation, over the switches that have it
  std::optional<KeyFigure> likest;
  double correlation = 0;  ///< with that figure, -1..1
};

struct FeelMap {
  std::array<FeelAxis, 2> axes;                  ///< the one with the larger share first
  std::vector<std::array<double, 2>> positions;  ///< of each switch, in lab noises from the mean of all
};

/// Principal axes of press, release and travel, weighted as in FeelDistance but with one common contact and
/// without slopes. Forces grow along the first axis; the second is signed so that the travel grows along it.
/// The same input gives the same map. Any thread.
FeelMap feelMapOf(const std::vector<LibrarySwitch>& switches);

}  // namespace detent::importer
