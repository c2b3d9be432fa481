// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Force graphs over each other, with a cursor that shows their values.

#include <memory>
#include <optional>
#include <vector>

#include <qcustomplot.h>

#include "editor/document/display_units.h"
#include "editor/document/graph_colors.h"
#include "model/button.h"

namespace detent::editor {

/// One graph of the comparison and its name there.
struct ComparedGraph {
  QString name;
  ForceGraph graph;
};

/// Press solid, release dashed, one colour per button. A cursor follows the pointer; a click pins a second
/// cursor, from which differences are counted. Escape or a click on the pinned cursor removes it. GUI thread.
class ComparePlot : public QCustomPlot {
  Q_OBJECT

 public:
  explicit ComparePlot(QWidget* parent = nullptr);

  void setGraphs(std::vector<ComparedGraph> graphs, const DisplayUnits& units);
  /// Values of all graphs at the cursor, and differences from the pinned cursor; empty while the pointer is
  /// outside.
  QString reading() const;
  /// Shows below the graphs the difference of each to the first, where both have values.
  void showDifferences(bool shown);
  /// The plot as a picture in light colours, with names, of the requested width; the shown plot does not
  /// change.
  QImage picture(QSize size_px = {1800, 1200}, double devicePixelRatio = 2) const;
  /// The same as vectors into any device; `size` in its units.
  void renderTo(QPaintDevice& device, QSize size) const;

 signals:
  void readingChanged(const QString& reading);

 protected:
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void dress();
  void drawCurves();
  void drawDifferences();
  std::unique_ptr<ComparePlot> forPicture(QSize size) const;
  void fitTicks();
  void fitNames(int width_px);
  void moveCursor(std::optional<double> at_mm);
  void pin(std::optional<double> at_mm);
  void place(QCPItemStraightLine& line, std::optional<double> at_mm);
  double millimetresAt(double x_px) const;
  QString valuesAt(double at_mm) const;
  QString differences() const;

  std::vector<ComparedGraph> graphs_;
  DisplayUnits units_;
  QCPItemStraightLine *cursor_, *pinned_;
  std::optional<double> cursor_mm_, pinned_mm_;
  QPoint pressedAt_;
  QCPAxisRect* differences_ = nullptr;  // null: not shown
  QCPMarginGroup* margins_;
};

}  // namespace detent::editor
