// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Switches on a map: places whose distances are as near as two dimensions allow to how far the switches feel
// apart.

#include <array>
#include <optional>
#include <vector>

#include "importer/library/library_switch.h"

namespace detent::importer {

/// One principal axis of what sets the switches apart.
struct FeelAxis {
  double share = 0;                 ///< of the variance that lies along it, 0..1
  std::optional<KeyFigure> likest;  ///< the figure that goes with it most, over the switches that have it
  double correlation = 0;           ///< with that figure, -1..1
};

struct FeelMap {
  std::array<FeelAxis, 2> axes;                  ///< the one with the larger share first
  std::vector<std::array<double, 2>> positions;  ///< of each switch, in lab noises from the mean of all
};

/// Principal axes of press, release and travel, weighted as in FeelDistance but with one contact and without
/// slopes. Forces grow along the first axis; the second is signed so that the travel grows along it. Same
/// input, same map. Any thread.
FeelMap feelMapOf(const std::vector<LibrarySwitch>& switches);

}  // namespace detent::importer
