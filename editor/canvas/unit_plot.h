// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Base of all plots of the editor: axes in the user's units, theme, zoom, pan. QCustomPlot draws static
// content (page, grid, axes) into its buffer; moving content is painted over it with every frame
// (docs/develop/decisions/1000-canvas-layers.md).

#include <qcustomplot.h>

#include "editor/canvas/plot_mapping.h"
#include "editor/document/graph_colors.h"
#include "editor/document/view_settings.h"

namespace detent::editor {

/// Quantity of an axis; plot coordinates are mm, N or N·s/mm whatever the user's units.
enum class PlotQuantity { displacement, force, damping };

/// GUI thread.
class UnitPlot : public QCustomPlot {
  Q_OBJECT

 public:
  UnitPlot(ViewSettings& settings, PlotQuantity x, PlotQuantity y, QWidget* parent);

  PlotMapping mapping() const;
  const GraphColors& colors() const { return colors_; }
  ViewSettings& settings() const { return settings_; }

  /// Shows this part of the plane (plot coordinates, normalised); sizes stay above the resolution of doubles.
  void showRange(const QRectF& range);
  QRectF shownRange() const;
  /// Zooms and keeps the value under `at_px` in place. factor > 1: closer.
  void zoomAt(QPointF at_px, double factorX, double factorY);
  /// Makes this part of the plot the whole view.
  void zoomTo(const QRectF& part_px);
  void panBy(QPointF by_px);
  /// Shows everything, until the user zooms or pans.
  void fit();
  bool fitted() const { return fitted_; }

 signals:
  /// The shown range or the size changed.
  void viewChanged();

 protected:
  /// Moving content: curves, points, feedback. Painted with every frame; must not change anything.
  virtual void drawContent(QPainter& painter, const PlotMapping& map) const = 0;
  /// Range shown by `fit`, plot coordinates, without margins.
  virtual QRectF contentRange() const = 0;

  /// The theme changed, so `colors()` returns other colours.
  virtual void colorsChanged() {}

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  // QCustomPlot's own mouse handling is not used.
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;

  /// Lays out axes and content in `size` and draws them; only for hidden plots, because the layout stays that
  /// of the picture.
  void drawAsPicture(QCPPainter& painter, QSize size);
  /// Returns true while an exported picture is drawn.
  bool exporting() const { return exporting_; }

  /// Pans with this button held; returns true if the event belongs to a pan.
  bool panWith(QMouseEvent* event, Qt::MouseButton button);

 private:
  class Content;
  void refreshBackground();
  void spaceLabels(QSize size);
  void applySettings();
  void applyColors();
  double unitOf(PlotQuantity quantity) const;
  QString labelOf(PlotQuantity quantity) const;

  ViewSettings& settings_;
  PlotQuantity xQuantity_, yQuantity_;
  GraphColors colors_;
  QSharedPointer<class UnitTicker> xTicker_, yTicker_;
  std::optional<QPointF> panFrom_px_;
  bool fitted_ = true;
  bool exporting_ = false;
  QPixmap background_;  ///< static content, opaque
  bool backgroundStale_ = true;
};

}  // namespace detent::editor
