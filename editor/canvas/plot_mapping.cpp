// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/plot_mapping.h"

#include <algorithm>

namespace detent::editor {

QRectF PlotMapping::shown() const {
  const QPointF lowest = toPlot(clip_px.bottomLeft()), highest = toPlot(clip_px.topRight());
  return {lowest.x(), lowest.y(), highest.x() - lowest.x(), highest.y() - lowest.y()};
}

QPointF PlotMapping::inClip(QPointF px) const {
  return {std::clamp(px.x(), clip_px.left(), clip_px.right()),
          std::clamp(px.y(), clip_px.top(), clip_px.bottom())};
}

QTransform PlotMapping::transform() const {
  QTransform map;
  map.translate(origin_px.x(), origin_px.y());
  map.scale(pxPerX, -pxPerY);
  map.translate(-originX, -originY);
  return map;
}

PlotMapping PlotMapping::magnified(QPointF at, const QRectF& lens_px, double times) const {
  return {lens_px, lens_px.center(), at.x(), at.y(), pxPerX * times, pxPerY * times};
}

}  // namespace detent::editor
