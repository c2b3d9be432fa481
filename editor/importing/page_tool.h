// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tools for mouse and keys on the page, one small class each. A tool knows only the view it works on, and
// changes ImportState in one step.

#include <memory>
#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace detent::editor {

class PageView;
enum class PageToolKind;

/// Events return true if they were handled; the view handles the others. `cancel` drops an unfinished action.
class PageTool {
 public:
  explicit PageTool(PageView& view) : view_(view) {}
  virtual ~PageTool() = default;
  PageTool(const PageTool&) = delete;
  PageTool& operator=(const PageTool&) = delete;

  virtual bool press(const QMouseEvent& event) = 0;
  virtual bool move(const QMouseEvent& event) = 0;
  virtual bool release(const QMouseEvent& event) = 0;
  virtual bool doubleClick(const QMouseEvent&) { return false; }
  virtual bool key(const QKeyEvent&) { return false; }
  /// Moves to the tool's next mark (Tab); returns false at the end.
  virtual bool selectNext(bool forward) {
    Q_UNUSED(forward);
    return false;
  }
  /// Shows a menu of the actions at a point; returns false if there is none.
  virtual bool menu(QPointF widget, QPoint global) {
    Q_UNUSED(widget);
    Q_UNUSED(global);
    return false;
  }
  virtual bool busy() const { return false; }
  virtual void cancel() {}
  virtual void paint(QPainter&) const {}
  virtual QCursor cursor(QPointF widget) const = 0;
  /// Description of the tool, one sentence.
  virtual QString hint() const = 0;

 protected:
  PageView& view_;
};

std::unique_ptr<PageTool> makeTool(PageToolKind kind, PageView& view);

}  // namespace detent::editor
