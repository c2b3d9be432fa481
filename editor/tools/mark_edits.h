// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pure functions from a mark and an edit to the next button, used by tools, keys and tables.

#include <QString>

#include "editor/canvas/graph_marks.h"
#include "model/edits.h"

namespace detent::editor {

/// Sides of a knot that a slope handle changes.
enum class SlopeSides {
  asItIs,  ///< both sides of a smooth knot, one side of a corner
  one      ///< the handle's own; a smooth knot becomes a corner
};

/// Moves a mark to another place. Knots, tactile points and turns move there. The segment of a section at
/// `mark.at` is bent between its two knots until it passes the force of `to`. Operating and reset points take
/// the displacement. The knot of a slope handle gets the slope towards `to`, which must lie on the handle's
/// side. Failures: as in model/edits.h.
Result<Button> moveMark(const Button& button, std::size_t state, const Mark& mark, CurvePoint to,
                        SlopeSides sides = SlopeSides::asItIs);

/// Sets the slope on one side of a knot (both if it is smooth).
Result<Button> setMarkSlope(const Button& button, std::size_t state, MarkId handle, double slope_N_per_mm,
                            SlopeSides sides = SlopeSides::asItIs);

/// Moves the end of a section: the tactile point or turn there, else the knot there, which is added if
/// needed.
Result<Button> moveSectionEnd(const Button& button, std::size_t state, Stroke stroke, const Section& section,
                              CurvePoint to);

/// Removes a mark's object: a knot, a jump with its tactile point, an operating or reset point.
Result<Button> removeMark(const Button& button, std::size_t state, MarkId mark);

/// Toggles a knot between corner and smooth.
Result<Button> toggleCorner(const Button& button, std::size_t state, MarkId knot);
Result<Button> addKnot(const Button& button, std::size_t state, Stroke stroke, double displacement_mm);
Result<Button> addJumpAt(const Button& button, std::size_t state, Stroke stroke, NewJump jump);

/// Index of the knot at a place of a stroke; nullopt without one.
std::optional<std::size_t> knotAt(const StrokeCurve& curve, double displacement_mm);

/// Labels of undo steps: "Move tactile point 1 of the press".
QString moveLabel(MarkId mark);
QString removeLabel(MarkId mark);

}  // namespace detent::editor
