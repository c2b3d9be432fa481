// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds the nearest existing switch for wanted figures ("a peak of 50 to 60 gf and a travel of at most 3.8
// mm"), and bends a button to have them.

#include <optional>
#include <vector>

#include "importer/library/store.h"
#include "model/button.h"

namespace detent::importer {

/// Distance of figures from their ranges, in units of the difference of two laboratories on such a figure; 0
/// if all ranges are satisfied; none if a figure is missing.
std::optional<double> missOf(const KeyFigures& figures, const std::vector<FigureRange>& ranges);

/// Bends a button's first state as little as possible so that its figures lie in the ranges; returns the
/// button unchanged if they do. Failure notCertain: the figures contradict each other, or the button does not
/// have one of them; it says which. Any thread.
Result<Button> buttonWithin(const Button& button, const std::vector<FigureRange>& ranges);

}  // namespace detent::importer
