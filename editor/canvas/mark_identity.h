// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which mark is still the same after an edit: marks are named by their place in a list, and lists change.

#include <optional>
#include <vector>

#include "editor/canvas/graph_marks.h"

namespace detent::editor {

/// One state of a button with its derived values, by value.
struct MarkedState {
  ButtonState state;
  GraphValues values;
};

/// The same mark after an edit; nullopt where the edit took it away. What stands before and after the changed
/// part of a list keeps its identity; inside it, what stands at the same place does, or, where as many are
/// left as there were, what has the same number. Any thread.
std::optional<MarkId> sameMark(MarkId mark, const MarkedState& before, const MarkedState& after);

}  // namespace detent::editor
