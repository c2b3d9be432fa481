// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines drawn in dashes or dots, made whole for the search of their course: where they climb, a search that earns by the
// column pays more for the gaps than the ink between them is worth, and ends at the first steep stretch.

#include <optional>

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// The ink with the gaps between its pieces filled along the shortest tree that joins them, one pixel wide; gaps much
/// longer than the usual one stay. Nothing where one piece holds a good part of the ink, or the gaps are of all lengths:
/// that is no line drawn in dashes.
std::optional<Plane> withDashesJoined(const Plane& own);

}  // namespace detent::importer::trace
