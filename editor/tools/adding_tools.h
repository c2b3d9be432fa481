// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tools that add something at a mouse press and shape it during the drag; and tools that change the view.

#include <memory>

#include "editor/tools/tool.h"

namespace detent::editor {

/// A click on a stroke adds a knot without changing the shape; a drag moves the new knot.
std::unique_ptr<Tool> addKnotTool(ToolContext& context);
/// A press on a stroke sets the tactile point, the drag pulls the valley (release: the hump) out of the
/// curve; a click adds a jump of usual size.
std::unique_ptr<Tool> addJumpTool(ToolContext& context);
/// Pans with the left button.
std::unique_ptr<Tool> panTool(ToolContext& context);
/// Shows travel, force and slope between two places; the ends snap to points and curves, with Ctrl not.
std::unique_ptr<Tool> measureTool(ToolContext& context);
/// A rectangle becomes the whole view; a click zooms in, with Shift out.
std::unique_ptr<Tool> zoomTool(ToolContext& context);

}  // namespace detent::editor
