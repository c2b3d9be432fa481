// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The part of a force graph on which two laboratories agree: the curve from first contact to the start of the
// bottom-out.

#include <optional>
#include <vector>

#include "model/button.h"

namespace detent::importer {

/// Forces at equal steps from first contact to the bottom-out; the release over the same displacements.
struct FeltShape {
  static constexpr std::size_t samples = 400;

  double travel_mm = 0;          ///< first contact to bottom-out, > 0
  std::vector<float> press_N;    ///< press forces at `samples` even displacements
  std::vector<float> release_N;  ///< as many forces of the release; empty if there is none
  bool operator==(const FeltShape&) const = default;
};

/// Empty for a graph that never reaches contact before its bottom-out. Any thread.
std::optional<FeltShape> feltShapeOf(const ForceGraph& graph);

}  // namespace detent::importer
