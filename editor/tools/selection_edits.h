// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Edits of several points, each one step: pure functions from the selected marks to the next button. Several
// selected marks are knots, operating and reset points; `pointsOf` converts others to their knots.

#include <vector>

#include "editor/canvas/graph_marks.h"
#include "model/edits.h"

namespace detent::editor {

/// The marks that can be part of a selection: the mark itself, the knot under a tactile point or turn, the
/// knots of a section. Empty without a knot.
std::vector<MarkId> pointsOf(MarkId mark, const ButtonState& state, const GraphValues& values);

/// All knots, operating and reset point.
std::vector<MarkId> allPoints(const ButtonState& state);

/// Moves all by the same distance; operating and reset points by its displacement.
Result<Button> moveSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                             double by_mm, double by_N);

/// Removes all.
Result<Button> removeSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks);

enum class GraphDirection { displacement, force };

/// Sets all knots to the displacement or force of the last one.
Result<Button> alignSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                              GraphDirection direction);

/// Distributes the knots of each stroke evenly between its first and last; needs three per stroke.
Result<Button> distributeSelection(const Button& button, std::size_t state, const std::vector<MarkId>& marks,
                                   GraphDirection direction);

}  // namespace detent::editor
