// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What all plots of the editor share: axes in the user's units, theme, zoom, pan, and two grounds.
// QCustomPlot draws what rests (page, grid, axes) into its buffer; what moves is painted over it with every
// frame (docs/develop/decisions/1000-canvas-layers.md).

#include <qcustomplot.h>

#include "editor/canvas/plot_mapping.h"
#include "editor/document/graph_colors.h"
#include "editor/document/view_settings.h"

namespace detent::editor {

/// What an axis counts; plot coordinates are mm, N or N·s/mm whatever the user's units.
enum class PlotQuantity { displacement, force, damping };

/// GUI thread.
class UnitPlot : public QCustomPlot {
  Q_OBJECT

 public:
  UnitPlot(ViewSettings& settings, PlotQuantity x, PlotQuantity y, QWidget* parent);

  PlotMapping mapping() const;
  const GraphColors& colors() const { return colors_; }
  ViewSettings& settings() const { return settings_; }

  /// Shows this part of the plane (plot coordinates, normalised); sizes are kept above what doubles resolve.
  void showRange(const QRectF& range);
  QRectF shownRange() const;
  /// Keeps the value under `at_px` where it is. factor > 1: closer.
  void zoomAt(QPointF at_px, double factorX, double factorY);
  /// This part of the plot becomes the whole view.
  void zoomTo(const QRectF& part_px);
  void panBy(QPointF by_px);
  /// Shows all of what the plot has; whoever zooms or pans by hand ends it.
  void fit();
  bool fitted() const { return fitted_; }

 signals:
  /// The shown range or the size changed.
  void viewChanged();

 protected:
  /// What moves: curves, points, feedback. Painted over the ground with every frame; must not change
  /// anything.
  virtual void drawContent(QPainter& painter, const PlotMapping& map) const = 0;
  /// What `fit` shows, plot coordinates, without margins.
  virtual QRectF contentRange() const = 0;

  /// The theme changed: `colors()` are other ones.
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

  /// Lays axes and content out in `size` and draws them; only for plots that no window shows, since the layout
  /// stays that of the picture.
  void drawAsPicture(QCPPainter& painter, QSize size);
  /// A picture for others is being drawn, not the screen.
  bool exporting() const { return exporting_; }

  /// Pans with this button held; true if the event belongs to a running pan.
  bool panWith(QMouseEvent* event, Qt::MouseButton button);

 private:
  class Content;
  void refreshGround();
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
  QPixmap ground_;  ///< what rests, opaque
  bool groundStale_ = true;
};

}  // namespace detent::editor
