// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/page_picture.h"

#include <algorithm>
#include <cmath>

namespace detent::editor {
namespace {

constexpr int smallestSide_px = 256;  // half-size copies end here

QImage scaledDown(const QImage& image, int largestSide_px) {
  if (std::max(image.width(), image.height()) <= largestSide_px) return image;
  return image.scaled(largestSide_px, largestSide_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

}  // namespace

QImage imageFrom(const importer::Raster& raster, int largestSide_px) {
  if (raster.empty()) return {};
  const QImage wrapped(raster.rgb.data(), raster.width_px, raster.height_px,
                       3 * static_cast<qsizetype>(raster.width_px), QImage::Format_RGB888);
  return scaledDown(wrapped, largestSide_px).convertToFormat(QImage::Format_RGB32);
}

QRectF boundsOf(const importer::Page& page) {
  const double margin = page.unit == importer::PageUnit::pixel ? 0.5 : 0;
  return {-margin, -margin, page.width, page.height};
}

PagePicture::PagePicture(const importer::Raster& raster, const importer::Homography& toPage,
                         int largestSide_px) {
  if (raster.empty()) return;
  levels_.push_back(imageFrom(raster, largestSide_px));
  while (std::min(levels_.back().width(), levels_.back().height()) >= 2 * smallestSide_px) {
    const QImage& last = levels_.back();
    levels_.push_back(last.scaled((last.width() + 1) / 2, (last.height() + 1) / 2, Qt::IgnoreAspectRatio,
                                  Qt::SmoothTransformation));
  }
  const double shrinkX = double(raster.width_px) / levels_.front().width(),
               shrinkY = double(raster.height_px) / levels_.front().height();
  const auto& m = toPage.m;  // Qt multiplies rows from the left
  const QTransform fromCentres(m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]);
  toPage_ = QTransform::fromScale(shrinkX, shrinkY) * QTransform::fromTranslate(-0.5, -0.5) * fromCentres;
}

std::size_t PagePicture::bytes() const {
  std::size_t sum = 0;
  for (const QImage& level : levels_) sum += static_cast<std::size_t>(level.sizeInBytes());
  return sum;
}

double PagePicture::pixelsPerUnit() const {
  const double area = std::abs(toPage_.determinant());
  return empty() || area == 0 ? 1 : 1 / std::sqrt(area);
}

void PagePicture::draw(QPainter& painter, const QTransform& pageToDevice) const {
  if (empty()) return;
  const QTransform whole = toPage_ * pageToDevice;
  const double shown = std::sqrt(std::abs(whole.determinant())) * painter.device()->devicePixelRatioF();
  std::size_t level = 0;
  for (double scale = shown; scale < 0.5 && level + 1 < levels_.size(); scale *= 2) ++level;
  const QImage& image = levels_[level];
  const QTransform toLevel0 = QTransform::fromScale(double(levels_[0].width()) / image.width(),
                                                    double(levels_[0].height()) / image.height());
  painter.save();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, shown < 3);  // enlarged pixels stay pixels
  painter.setTransform(toLevel0 * whole, true);
  // Draws only the visible part, because a page at high zoom is far larger than the window.
  const QRectF seen = painter.transform().inverted().mapRect(QRectF(painter.viewport()));
  const QRect part = seen.toAlignedRect().adjusted(-2, -2, 2, 2) & image.rect();
  if (!part.isEmpty()) painter.drawImage(QRectF(part), image, QRectF(part));
  painter.restore();
}

std::optional<QColor> PagePicture::colorAt(QPointF page) const {
  if (empty()) return {};
  const QPointF at = toPage_.inverted().map(page);
  const QPoint pixel(static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())));
  if (!levels_.front().rect().contains(pixel)) return {};
  return levels_.front().pixelColor(pixel);
}

}  // namespace detent::editor
