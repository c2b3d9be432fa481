// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drags findings on the page: corners and edges of the plot frame, ticks of the axes, masks, named points.

#include <optional>
#include <vector>

#include "editor/importing/page_tool.h"
#include "editor/importing/page_view.h"

namespace detent::editor {

/// A corner, edge, tick, mask or point on the page that can be dragged.
struct PageHandle {
  enum class Kind { corner, edge, givenTick, foundTick, mask, point } kind = Kind::corner;
  GraphAxis axis = GraphAxis::x;  ///< axis of a tick
  std::size_t index = 0;  ///< corner 0..3, edge from corner i to i+1, tick or mask of the shown corrections
                          ///< (found: of the result), point among the drawn marks
  QPointF at;             ///< widget
  friend bool operator==(const PageHandle& a, const PageHandle& b) {
    return a.kind == b.kind && a.axis == b.axis && a.index == b.index;
  }
};

/// All handles of the current graph, the ones drawn on top first.
std::vector<PageHandle> handlesOf(const PageView& view);

class AdjustTool : public PageTool {
 public:
  using PageTool::PageTool;
  bool press(const QMouseEvent& event) override;
  bool move(const QMouseEvent& event) override;
  bool release(const QMouseEvent& event) override;
  bool doubleClick(const QMouseEvent& event) override;
  bool key(const QKeyEvent& event) override;
  bool selectNext(bool forward) override;
  bool menu(QPointF widget, QPoint global) override;
  bool busy() const override { return drag_.has_value(); }
  void cancel() override;
  void paint(QPainter& painter) const override;
  QCursor cursor(QPointF widget) const override;
  QString hint() const override;

 private:
  struct Drag {
    PageHandle handle;
    QPointF from;
    QPointF to{};
    Corrections before;
    FrameCorners corners;
    bool moved = false;
  };
  std::optional<PageHandle> handleAt(QPointF widget) const;
  /// The tick whose mark or value is at a place, even if a corner is there too.
  std::optional<PageHandle> tickAt(QPointF widget) const;
  Corrections moved(const Drag& drag, QPointF to, Qt::KeyboardModifiers modifiers) const;
  QString label(const PageHandle& handle) const;
  bool nudge(QPointF widgetDelta);
  bool remove(const PageHandle& handle);
  bool typeValue(const PageHandle& handle);
  void paintDraggedPoint(QPainter& painter) const;
  std::optional<MarkCorrection> markOf(const PageHandle& handle) const;
  void give(const MarkCorrection& mark, const QString& label);

  std::optional<Drag> drag_;
  std::optional<PageHandle> active_, hovered_;
};

}  // namespace detent::editor
