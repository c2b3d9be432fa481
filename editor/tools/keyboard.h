// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Working on the graph without a mouse.

#include "editor/tools/selection_edits.h"
#include "editor/tools/tool.h"

namespace detent::editor {

/// One press of an arrow key; Shift: ten times, Alt: a tenth.
inline constexpr double nudge_mm = 0.01, nudge_N = 0.001, nudgeSlope_N_per_mm = 0.001;

/// Tab and Shift+Tab go through the points (of very many, not through plain knots) and leave the canvas after
/// the last, arrow keys nudge the selected mark (one undo step as long as it is the same one), Delete removes
/// it, Insert adds a knot halfway to the next one, C makes a corner smooth and back, S goes through a knot's
/// slope handles, P pins it or takes the pin out, Enter and F2 ask for its values, Escape lets go.
class Keyboard {
 public:
  explicit Keyboard(ToolContext& context) : context_(context) {}
  bool pressed(int key, Qt::KeyboardModifiers modifiers);
  bool wants(int key, Qt::KeyboardModifiers modifiers) const;

  /// Also behind the menu's actions. They say why not, where something stands in the way.
  void removeSelected();
  void toggleSelectedCorner();
  void togglePin();
  void selectAll();
  void align(GraphDirection direction);
  void distribute(GraphDirection direction);
  /// The selected knot, or the one under the selected tactile point or turn.
  std::optional<MarkId> selectedKnot() const;

 private:
  bool walk(int by);
  bool nudge(int key, Qt::KeyboardModifiers modifiers);
  bool nudgeAll(double right, double up);
  bool nextSlopeHandle();
  void addKnotBeyond();
  void apply(const Result<Button>& next, const QString& label, const QString& mergeKey = {});

  ToolContext& context_;
};

}  // namespace detent::editor
