// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Plots whose numbers fall to the right or upwards (travel from right to left, force downwards) are mirrored
// before their curves are followed: everything after the axes counts on a press that begins at the left and a
// force that grows upwards. Any thread.

#include <optional>

#include "importer/locate_graphs.h"

namespace detent::importer {

/// The graph as in a mirror, so that both scales rise; the map to the page turns with it. Empty if they rise
/// already, and if both fall or the view was turned: no program draws so. Texts must have been read: mirrored
/// text cannot be.
std::optional<LocatedGraph> mirroredToRise(const LocatedGraph& graph);

}  // namespace detent::importer
