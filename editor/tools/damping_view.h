// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Damping b(x) of a button (Shrestha, "Basic model": F = -kx - bv), with its editing.

#include <optional>

#include "editor/canvas/unit_plot.h"
#include "editor/document/button_document.h"

namespace detent::editor {

/// Points are dragged, added by a double click on the line, removed by Delete, visited by Tab and moved by
/// the arrow keys (0.01 mm, 0.001 N·s/mm). GUI thread.
class DampingView : public UnitPlot {
  Q_OBJECT

 public:
  DampingView(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
  std::optional<std::size_t> selected() const { return selected_; }
  void cancelDrag();

 signals:
  void said(const QString& text);

 protected:
  void drawContent(QPainter& painter, const PlotMapping& map) const override;
  QRectF contentRange() const override;
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  const std::vector<DampingPoint>& points() const;
  std::optional<std::size_t> pointAt(QPointF px) const;
  void movePoint(std::size_t index, DampingPoint to);
  void apply(std::vector<DampingPoint> next, const QString& label, const QString& mergeKey = {});
  void select(std::optional<std::size_t> index);
  void refuse(const QString& why);
  void endDrag();
  bool selectBy(int by);
  bool nudge(int key, Qt::KeyboardModifiers modifiers);

  ButtonDocument& document_;
  std::optional<std::size_t> selected_;
  std::optional<QPointF> grab_px_;  ///< pointer minus point during a drag
  bool dragging_ = false;
  QString refused_;
};

}  // namespace detent::editor
