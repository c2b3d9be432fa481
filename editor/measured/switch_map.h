// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The shown switches as dots: over two figures or the two principal axes, coloured by kind.

#include <optional>
#include <set>
#include <vector>

#include <qcustomplot.h>

#include "editor/measured/measured_table.h"

namespace detent::editor {

/// Quantity of a direction of the map: a figure, or a principal axis (0 or 1).
struct MapScale {
  std::optional<KeyFigure> figure;
  std::size_t axis = 0;
  friend bool operator==(const MapScale&, const MapScale&) = default;
};

/// A click selects the nearest dot, a drag all dots in the rectangle; Ctrl adds them to the selection. The
/// wheel zooms, a double click shows everything again. Switches without a figure are not on the map. GUI
/// thread.
class SwitchMap : public QCustomPlot {
  Q_OBJECT

 public:
  /// `table` must outlive this. Call redraw() after it changed.
  explicit SwitchMap(const MeasuredTable& table, QWidget* parent = nullptr);

  void setScales(const MapScale& x, const MapScale& y);
  void setUnits(const DisplayUnits& units);
  /// Sets the switches that are highlighted.
  void setChosen(std::set<SwitchIndex> chosen);
  /// Draws the dots again at the next repaint, once for all changes before it.
  void redraw();
  /// Position of a switch in the widget; empty if it has none or is not shown.
  std::optional<QPointF> placeOf(SwitchIndex which);
  /// Title of an axis: "Peak force (cN)", or "Principal axis 1: 64 %, Peak force", with its share of the
  /// variance and the figure that correlates with it most.
  QString titleOf(const MapScale& scale) const;

 signals:
  void chosen(std::set<detent::editor::SwitchIndex> switches);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Dot {
    SwitchIndex which = 0;
    double x = 0, y = 0;
  };
  std::optional<double> valueOf(SwitchIndex which, const MapScale& scale) const;
  std::optional<Dot> dotOf(SwitchIndex which) const;
  std::optional<SwitchIndex> nearestTo(QPointF at_px);
  void bringUp();
  void dress();
  void fill();
  void drawChosen();
  void choose(std::set<SwitchIndex> switches, Qt::KeyboardModifiers keys);

  const MeasuredTable& table_;
  MapScale x_, y_;
  DisplayUnits units_;
  std::vector<Dot> dots_;
  std::set<SwitchIndex> chosen_;
  QPoint pressedAt_;
  bool stale_ = true;    // the drawn dots are out of date
  bool fitNext_ = true;  // show the whole map at the next paint: the library or a scale changed
};

}  // namespace detent::editor
