// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Mirrors plots whose numbers fall to the right or upwards (travel from right to left, force downwards)
// before their curves are traced. All later steps require a press that begins at the left and a force that
// grows upwards. Any thread.

#include <optional>

#include "importer/locate_graphs.h"

namespace detent::importer {

/// The mirrored graph, in which both scales rise, with its map to the page adjusted. Empty if the scales rise
/// already, if both fall, or if the view was turned, because no program draws such plots. Texts must be read
/// before, because mirrored text cannot be read.
std::optional<LocatedGraph> mirroredToRise(const LocatedGraph& graph);

}  // namespace detent::importer
