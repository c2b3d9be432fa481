// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The datasheet page under the curves, aligned to the axes.

#include <QImage>
#include <QTransform>
#include <vector>

#include "editor/canvas/unit_plot.h"

namespace detent::editor {

/// Draws a picture whose pixels have positions in plot coordinates. Keeps half-size copies, so that drawing
/// costs depend on the screen, not on the page. GUI thread.
class PageUnderlay : public QCPLayerable {
 public:
  explicit PageUnderlay(UnitPlot& plot);  ///< owned by the plot

  /// `pixelToAxes`: from picture pixels (centre of the top left one at 0,0) to plot coordinates (may be
  /// projective).
  void setPage(const QImage& page, const QTransform& pixelToAxes);
  /// Sets the part of the plot, in plot coordinates, in which the page is drawn. Outside the page's plot
  /// frame are the page's own tick labels, which must not appear beside those of the plot. Empty: draws
  /// everywhere.
  void setFrame(const QRectF& frame) { frame_ = frame; }
  void clear();
  bool empty() const { return page_.isNull(); }

  /// Exchanges dark and light and keeps hues, for a dark window.
  void setDarkPaper(bool dark);

  /// 0..1
  void setOpacity(double opacity);
  double opacity() const { return opacity_; }

  /// Draws the part shown by the map, clipped to it; the magnifier has its own map.
  void paint(QPainter& painter, const PlotMapping& map) const;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;
  QRect clipRect() const override;

 private:
  UnitPlot& plot_;
  void build();

  QImage page_;                  ///< original
  std::vector<QImage> pyramid_;  ///< [0] the shown page, each next one half as wide
  bool darkPaper_ = false;
  QTransform pixelToAxes_;
  QRectF frame_;
  double opacity_ = 0.5;
};

}  // namespace detent::editor
