// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Displacement over force: where a graph passes each multiple of a force.

#include <string>

#include "model/force_graph.h"
#include "model/result.h"

namespace detent {

/// Limit of table rows.
inline constexpr std::size_t mostForceSteps = 100000;

/// Returns CSV with the header `stroke,force_N,displacement_mm`: one row for each place where a stroke passes
/// a multiple of `step_N`, in the order travelled. A force that is passed several times has several rows; a
/// stroke that runs along a multiple has rows for both ends. Displacements to 1e-9 mm. Failure wrongUsage:
/// the step is not above 0, or gives more than mostForceSteps rows.
Result<std::string> forceStepsFrom(const ForceGraph& graph, double step_N);

}  // namespace detent
