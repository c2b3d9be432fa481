// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Editing the graph by keyboard.

#include "editor/tools/selection_edits.h"
#include "editor/tools/tool.h"

namespace detent::editor {

/// Step of one arrow key press; Shift: ten times, Alt: a tenth.
inline constexpr double nudge_mm = 0.01, nudge_N = 0.001, nudgeSlope_N_per_mm = 0.001;

/// Tab and Shift+Tab visit the points (of very many, without plain knots) and leave the canvas after the
/// last; arrow keys move the selected mark (one undo step per mark), Delete removes it, Insert adds a knot
/// halfway to the next one, C toggles a corner, S visits a knot's slope handles, P toggles its pin, Enter and
/// F2 open its values, Escape deselects.
class Keyboard {
 public:
  explicit Keyboard(ToolContext& context) : context_(context) {}
  bool pressed(int key, Qt::KeyboardModifiers modifiers);
  bool wants(int key, Qt::KeyboardModifiers modifiers) const;

  /// Removes the selection; also used by the menu's actions. Reports the reason if it is impossible.
  void removeSelected();
  void toggleSelectedCorner();
  void togglePin();
  void selectAll();
  void align(GraphDirection direction);
  void distribute(GraphDirection direction);
  /// The selected knot, or the one under the selected tactile point or turn.
  std::optional<MarkId> selectedKnot() const;

 private:
  bool selectBy(int by);
  bool nudge(int key, Qt::KeyboardModifiers modifiers);
  bool nudgeAll(double right, double up);
  bool nextSlopeHandle();
  void addKnotBeyond();
  void apply(const Result<Button>& next, const QString& label, const QString& mergeKey = {});

  ToolContext& context_;
};

}  // namespace detent::editor
