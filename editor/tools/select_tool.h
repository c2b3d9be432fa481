// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "editor/canvas/mark_identity.h"
#include "editor/tools/tool.h"

namespace detent::editor {

/// Selects and moves points, slope handles and sections; a drag on the empty background selects the points in
/// its rectangle. Shift toggles the selection; a drag moves all selected points. A click on a selected mark
/// takes the one beneath; a double click adds a knot, or toggles a corner.
class SelectTool : public Tool {
 public:
  using Tool::Tool;
  void leave() override;
  bool pressed(const PointerInput& input) override;
  bool moved(const PointerInput& input) override;
  bool released(const PointerInput& input) override;
  bool doubleClicked(const PointerInput& input) override;
  void dragCancelled() override;
  QString hint() const override;

 private:
  enum class Holding { nothing, mark, emptySpace };
  void hover(const PointerInput& input);
  void beginDrag(const PointerInput& input);
  void beginGroupDrag();
  void takeBeneath(const PointerInput& input);
  void toggleHeld();
  void bandTo(const PointerInput& input);

  Holding holding_ = Holding::nothing;
  std::optional<Mark> held_;
  bool wasSelected_ = false;
  bool adding_ = false;                 ///< Shift was down at the mouse press
  std::vector<MarkId> selectedBefore_;  ///< selected marks when the rectangle was begun
  std::optional<MarkedState> pressedOn_;
  QPointF pressed_px_;
  CurvePoint pressedAt_;
  bool travelled_ = false;
};

/// Reports the selected mark and its present place; nothing without exactly one.
void saySelected(const ToolContext& context);

}  // namespace detent::editor
