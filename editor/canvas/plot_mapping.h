// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Map between plot values (mm, N) and pixels.

#include <QPointF>
#include <QRectF>
#include <QTransform>

namespace detent::editor {

/// A linear map of both axes. Pixels are continuous: the gridline of a value runs through its pixel's centre.
/// Plain value.
struct PlotMapping {
  QRectF clip_px;     ///< area in which curves may be drawn
  QPointF origin_px;  ///< position of (originX, originY)
  double originX = 0, originY = 0;
  double pxPerX = 1, pxPerY = 1;  ///< > 0; y counts upwards

  QPointF toPixel(double x, double y) const {
    return {origin_px.x() + (x - originX) * pxPerX, origin_px.y() - (y - originY) * pxPerY};
  }
  QPointF toPixel(QPointF plot) const { return toPixel(plot.x(), plot.y()); }
  QPointF toPlot(QPointF px) const {
    return {originX + (px.x() - origin_px.x()) / pxPerX, originY - (px.y() - origin_px.y()) / pxPerY};
  }
  /// Values at the edges of the clip: left, right (x) and bottom, top (y) as a rectangle with positive size.
  QRectF shown() const;
  /// The pixel position in the clip that is nearest to `px`.
  QPointF inClip(QPointF px) const;
  /// Plot coordinates to pixels.
  QTransform transform() const;
  /// The surroundings of `at` (plot coordinates) enlarged `times`, drawn into `lens_px` with `at` in the
  /// middle.
  PlotMapping magnified(QPointF at, const QRectF& lens_px, double times) const;

  friend bool operator==(const PlotMapping&, const PlotMapping&) = default;
};

}  // namespace detent::editor
