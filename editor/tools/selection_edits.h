// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Edits of several points at once, each one step: pure functions from the selected marks to the next button.
// Several selected marks are knots, operating and reset points; `pointsOf` makes others into the knots they
// stand on.

#include <vector>

#include "editor/canvas/graph_marks.h"
#include "model/edits.h"

namespace detent::editor {

/// What of a mark can be one of several: the mark itself, the knot under a tactile point or turn, the knots
/// of a section. Empty where no knot stands there.
std::vector<MarkId> pointsOf(MarkId mark, const ButtonState& state, const GraphValues& values);

/// All knots, operating and reset point.
std::vector<MarkId> allPoints(const ButtonState& state);

/// Moves all by the same way; operating and reset points by its displacement.
Result<Button> moveSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                             double by_mm, double by_N);

/// Takes all away.
Result<Button> removeSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks);

enum class GraphDirection { displacement, force };

/// Puts all knots at the displacement or the force of the last one.
Result<Button> alignSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                              GraphDirection direction);

/// Puts the knots of each stroke at equal distances between its first and last; needs three of a stroke.
Result<Button> distributeSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                                   GraphDirection direction);

}  // namespace detent::editor
