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

/// A click chooses the nearest dot, a drag all in the rectangle; with Ctrl they are added to those chosen.
/// The wheel zooms, a double click shows all again. Switches without a figure have no place. GUI thread.
class SwitchMap : public QCustomPlot {
  Q_OBJECT

 public:
  /// `table` must outlive this; redraw() after it changed.
  explicit SwitchMap(const MeasuredTable& table, QWidget* parent = nullptr);

  void setScales(const MapScale& x, const MapScale& y);
  void setUnits(const DisplayUnits& units);
  /// Sets the switches that are highlighted.
  void setChosen(std::set<SwitchIndex> chosen);
  /// Repaints once for all changes until the window is painted.
  void redraw();
  /// Position of a switch in the widget; empty if it has none or is not shown.
  std::optional<QPointF> placeOf(SwitchIndex which);
  /// "Peak force (cN)", "Principal axis 1: 64 %, Peak force": its share of what differs, the figure it goes
  /// with most.
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
