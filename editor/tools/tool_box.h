// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Owns the tools, passes canvas events to the active one and keeps the rules common to all tools.

#include <array>
#include <memory>
#include <QObject>

#include "editor/tools/keyboard.h"
#include "editor/tools/tool.h"

namespace detent::editor {

enum class ToolKind { select, addKnot, addJump, pan, zoom, measure };
inline constexpr std::size_t toolCount = 6;

/// Escape cancels a drag; undo and a change of state end it; a tool is left without one. GUI thread.
class ToolBox : public QObject, public CanvasEvents {
  Q_OBJECT

 public:
  /// All three must outlive it.
  ToolBox(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas, QObject* parent = nullptr);
  ~ToolBox() override;

  ToolKind tool() const { return current_; }
  void setTool(ToolKind kind);
  bool dragging() const { return drag_.running(); }
  void cancelDrag();
  Keyboard& keyboard() { return keyboard_; }

  bool pointerPressed(const PointerInput& input) override;
  bool pointerMoved(const PointerInput& input) override;
  bool pointerReleased(const PointerInput& input) override;
  bool doubleClicked(const PointerInput& input) override;
  bool keyPressed(int key, Qt::KeyboardModifiers modifiers) override;
  bool wantsKey(int key, Qt::KeyboardModifiers modifiers) const override;
  void pointerLeft() override;
  void contextMenu(const PointerInput& input, QPoint global_px) override;

 signals:
  void toolChanged(detent::editor::ToolKind kind);
  void said(const QString& text);
  /// Requests editing of the selected point's values.
  void valuesRequested(detent::editor::FirstValue first);
  void contextMenuRequested(QPoint global_px);

 private:
  void graphReplaced();
  Tool& currentTool() { return *tools_[static_cast<std::size_t>(current_)]; }

  GraphCanvas& canvas_;
  GraphDrag drag_;
  ToolContext context_;
  Keyboard keyboard_;
  std::array<std::unique_ptr<Tool>, toolCount> tools_;
  ToolKind current_ = ToolKind::select;
  bool leftDown_ = false;
};

}  // namespace detent::editor
