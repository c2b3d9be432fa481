// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Travel over force: where a graph passes each multiple of a force, for those who think in grams, not in millimetres.

#include <string>

#include "model/force_graph.h"
#include "model/result.h"

namespace detent {

/// Rows the table may have at most.
inline constexpr std::size_t mostForceSteps = 100000;

/// CSV with the header `stroke,force_N,displacement_mm`: a row for each place where a stroke passes a multiple of `step_N`, in the
/// order travelled. A force that is passed several times (before and after a peak) has a row each; where a stroke runs along a
/// multiple, the places where it comes to it and leaves it. Displacements to 1e-9 mm of the curve. Failure wrongUsage: the step
/// is not above 0, or so small that the rows would be more than mostForceSteps.
Result<std::string> forceStepsFrom(const ForceGraph& graph, double step_N);

}  // namespace detent
