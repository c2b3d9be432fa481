// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tools that add something at a mouse press and shape it during the drag; and tools that change the view.

#include "editor/tools/tool.h"

namespace detent::editor {

/// Shows where a press would add something, and shapes it during the drag.
class AddingTool : public Tool {
 public:
  using Tool::Tool;
  void leave() override;
  bool moved(const PointerInput& input) override;
  bool released(const PointerInput& input) override;
  Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
};

/// A click on a stroke adds a knot without changing the shape; a drag moves the new knot.
class AddKnotTool : public AddingTool {
 public:
  using AddingTool::AddingTool;
  bool pressed(const PointerInput& input) override;
  QString hint() const override;
};

/// A press on a stroke sets the tactile point, the drag pulls the valley (release: the hump) out of the
/// curve; a click adds a jump of usual size.
class AddJumpTool : public AddingTool {
 public:
  using AddingTool::AddingTool;
  bool pressed(const PointerInput& input) override;
  QString hint() const override;
};

/// Pans with the left button.
class PanTool : public Tool {
 public:
  using Tool::Tool;
  void leave() override;
  bool pressed(const PointerInput& input) override;
  bool moved(const PointerInput& input) override;
  bool released(const PointerInput& input) override;
  Qt::CursorShape cursor() const override { return Qt::OpenHandCursor; }
  QString hint() const override;

 private:
  std::optional<QPointF> last_px_;
};

/// Shows travel, force and slope between two places; the ends snap to points and curves, with Ctrl not.
class MeasureTool : public Tool {
 public:
  using Tool::Tool;
  void leave() override;
  bool pressed(const PointerInput& input) override;
  bool moved(const PointerInput& input) override;
  bool released(const PointerInput& input) override;
  Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  QString hint() const override;

 private:
  CurvePoint placeAt(const PointerInput& input) const;
  std::optional<CurvePoint> from_;
};

/// A rectangle becomes the whole view; a click zooms in, with Shift out.
class ZoomTool : public Tool {
 public:
  using Tool::Tool;
  void leave() override;
  bool pressed(const PointerInput& input) override;
  bool moved(const PointerInput& input) override;
  bool released(const PointerInput& input) override;
  Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
  QString hint() const override;

 private:
  std::optional<QPointF> from_px_;
};

}  // namespace detent::editor
