// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// "One that has a peak of 50 to 60 gf and a travel of at most 3.8 mm": the nearest that exists, and a button
// that has them.

#include <optional>
#include <vector>

#include "importer/library/store.h"
#include "model/button.h"

namespace detent::importer {

/// Distance of figures from their ranges, in units of the difference of two laboratories on such a figure; 0
/// if they keep all of them, none if one is missing.
std::optional<double> missOf(const KeyFigures& figures, const std::vector<FigureRange>& ranges);

/// Bends a button's first state by the least that brings its figures into the ranges; the button itself where
/// they are. Failure notCertain: the figures contradict each other, or the button has none of that name; it
/// says which. Any thread.
Result<Button> buttonWithin(const Button& button, const std::vector<FigureRange>& ranges);

}  // namespace detent::importer
