// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds marks again after an edit: marks are identified by list positions, and edits change lists.

#include <optional>
#include <vector>

#include "editor/canvas/graph_marks.h"

namespace detent::editor {

/// One state of a button with its derived values, by value.
struct MarkedState {
  ButtonState state;
  GraphValues values;
};

/// The same mark after an edit; nullopt if the edit removed it. List parts before and after the change keep
/// their identity; inside it, marks at the same place, or with the same index if the number is unchanged. Any
/// thread.
std::optional<MarkId> sameMark(MarkId mark, const MarkedState& before, const MarkedState& after);

}  // namespace detent::editor
