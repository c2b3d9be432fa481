// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Force at even steps of travel or at given travels.

#include <string>
#include <vector>

#include "model/force_graph.h"
#include "model/result.h"

namespace detent {

/// Limit of travels for one table.
inline constexpr std::size_t mostTravelSteps = 100000;

/// Returns, increasing: each multiple of `step_mm` that the press passes, the beginnings of both strokes'
/// bottom-outs, and the press's end. Failure wrongUsage: the step is not above 0, or gives more than
/// mostTravelSteps travels.
Result<std::vector<double>> travelsAtEach(double step_mm, const ForceGraph& graph);

/// Returns `travels_mm` if the press passes all of them. Failure wrongUsage: there is none, or one lies
/// outside the travel.
Result<std::vector<double>> travelsWithin(std::vector<double> travels_mm, const ForceGraph& graph);

/// Returns CSV with the header `stroke,displacement_mm,force_N`, in the order travelled if `travels_mm`
/// (one or more) increase; 12 digits. A stroke has no row outside its travel, and two where it is vertical.
std::string csvAtTravels(const std::vector<double>& travels_mm, const ForceGraph& graph);

}  // namespace detent
