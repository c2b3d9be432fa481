// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Joins dashed and dotted lines before the path search. Where such a line climbs, a search that earns by the
// column pays more for gaps than the dashes are worth.

#include <optional>

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// Returns the coverage with gaps filled along the shortest tree that joins the pieces, one pixel wide; gaps
/// much longer than the usual one stay. nullopt if one piece holds much of the coverage, or the gaps vary:
/// not a dashed line.
std::optional<Plane> withDashesJoined(const Plane& own);

}  // namespace detent::importer::trace
