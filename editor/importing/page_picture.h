// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pixels of a page as the screen can draw them fast.

#include <QImage>
#include <QPainter>
#include <QRectF>
#include <QTransform>
#include <vector>

#include "importer/importer.h"

namespace detent::editor {

/// A picture with its place on the page, and half-size copies, so that the cost of drawing depends on the
/// screen. Copies share the pixels. Made on the import thread, drawn on the GUI thread.
class PagePicture {
 public:
  PagePicture() = default;
  /// `toPage` maps pixel centres (0,0 top left) to page units. Pictures with a side above `largestSide_px`
  /// are scaled down to it.
  PagePicture(const importer::Raster& raster, const importer::Homography& toPage, int largestSide_px);

  bool empty() const { return levels_.empty(); }
  QSize size_px() const { return empty() ? QSize() : levels_.front().size(); }
  std::size_t bytes() const;
  /// Draws it with `pageToDevice`; picks the copy that comes nearest to the screen's pixels.
  void draw(QPainter& painter, const QTransform& pageToDevice) const;
  /// Colour of the pixel at a place of the page; nothing outside.
  std::optional<QColor> colorAt(QPointF page) const;
  /// Pixels per page unit, mean of both directions.
  double pixelsPerUnit() const;

 private:
  std::vector<QImage> levels_;  ///< [0] the sharpest, each next one half as wide
  QTransform toPage_;           ///< pixel corners of level 0 (0..width) to page units
};

/// The raster as QImage, scaled down so that no side is longer than `largestSide_px`.
QImage imageFrom(const importer::Raster& raster, int largestSide_px);

/// The page's bounds in page units: pictures start half a pixel before the first centre.
QRectF boundsOf(const importer::Page& page);

}  // namespace detent::editor
