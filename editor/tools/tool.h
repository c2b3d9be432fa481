// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A mouse tool: a state the canvas is in. All it may touch stands in its ToolContext.

#include <functional>
#include <QString>

#include "editor/canvas/graph_canvas.h"
#include "editor/tools/graph_drag.h"

namespace detent::editor {

/// Which value of a point is typed first.
enum class FirstValue { displacement, force };

/// What tools work on; the seam where tests take hold of them.
struct ToolContext {
  ButtonDocument& document;
  ViewSettings& settings;
  GraphCanvas& canvas;
  GraphDrag& drag;
  std::function<void(const QString&)> say;    ///< refusals and hints, for the status bar
  std::function<void(FirstValue)> askValues;  ///< of the selected point, beside it

  /// A drag or an operation's dialog holds the button; nothing else may change it.
  bool busy() const { return document.history().dragging(); }
};

/// Events answer whether they were handled. A tool has no drag running when it is left. GUI thread.
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
  /// The drag this tool had begun was taken away (Escape, undo).
  virtual void dragCancelled() {}
  virtual Qt::CursorShape cursor() const { return Qt::ArrowCursor; }
  /// One sentence: what the mouse does now.
  virtual QString hint() const = 0;

 protected:
  ToolContext& context_;
};

}  // namespace detent::editor
