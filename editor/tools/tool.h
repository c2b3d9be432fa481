// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A mouse tool: a mode of the canvas. Everything it may touch is in its ToolContext.

#include <functional>
#include <QString>

#include "editor/canvas/graph_canvas.h"
#include "editor/tools/graph_drag.h"

namespace detent::editor {

/// The value of a point that is typed first.
enum class FirstValue { displacement, force };

/// Environment of tools, also used by tests.
struct ToolContext {
  ButtonDocument& document;
  ViewSettings& settings;
  GraphCanvas& canvas;
  GraphDrag& drag;
  std::function<void(const QString&)> say;    ///< refusals and hints, for the status bar
  std::function<void(FirstValue)> askValues;  ///< opens the values of the selected point

  /// Returns true while a drag or an operation's dialog holds the button; nothing else may change it then.
  bool busy() const { return document.history().dragging(); }
};

/// Event functions return true if the event was handled. A tool has no running drag when it is deselected.
/// GUI thread.
class Tool {
 public:
  explicit Tool(ToolContext& context) : context_(context) {}
  virtual ~Tool() = default;
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;

  virtual void enter() {}
  virtual void leave() {}
  virtual bool pressed(const PointerInput&) { return false; }
  virtual bool moved(const PointerInput&) { return false; }
  virtual bool released(const PointerInput&) { return false; }
  virtual bool doubleClicked(const PointerInput&) { return false; }
  /// The drag of the tool was cancelled (Escape, undo).
  virtual void dragCancelled() {}
  virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
  /// One sentence about the present effect of the mouse.
  virtual QString hint() const = 0;

 protected:
  ToolContext& context_;
};

}  // namespace detent::editor
