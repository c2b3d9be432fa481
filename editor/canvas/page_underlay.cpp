#include "editor/canvas/page_underlay.h"

#include <algorithm>
#include <cmath>

namespace detent::editor {

PageUnderlay::PageUnderlay(QCustomPlot* plot) : QCPLayerable(plot) {}

void PageUnderlay::setPage(const QImage& page, const QTransform& pixelToAxes) {
  pixelToAxes_ = pixelToAxes;
  pyramid_.clear();
  if (page.isNull()) return;
  pyramid_.push_back(page.convertToFormat(QImage::Format_RGB32));
  constexpr int smallest_px = 256;
  while (pyramid_.back().width() > smallest_px && pyramid_.back().height() > smallest_px) {
    const QImage& last = pyramid_.back();
    pyramid_.push_back(
        last.scaled(last.width() / 2, last.height() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }
}

void PageUnderlay::clear() { pyramid_.clear(); }

void PageUnderlay::setOpacity(double opacity) { opacity_ = std::clamp(opacity, 0.0, 1.0); }

void PageUnderlay::applyDefaultAntialiasingHint(QCPPainter* painter) const {
  applyAntialiasingHint(painter, mAntialiased, QCP::aeOther);
}

QRect PageUnderlay::clipRect() const { return mParentPlot->axisRect()->rect(); }

void PageUnderlay::draw(QCPPainter* painter) {
  if (pyramid_.empty() || opacity_ <= 0) return;
  // Plot coordinates to screen is linear on both axes: two points give it.
  const QCPRange x = mParentPlot->xAxis->range(), y = mParentPlot->yAxis->range();
  const QRect rect = clipRect();
  QTransform axesToScreen;
  axesToScreen.translate(rect.left(), rect.bottom() + 1);
  axesToScreen.scale(rect.width() / x.size(), -rect.height() / y.size());
  axesToScreen.translate(-x.lower, -y.lower);
  const QTransform pixelToScreen = pixelToAxes_ * axesToScreen;

  const QPointF origin = pixelToScreen.map(QPointF(0, 0));
  const QPointF across = pixelToScreen.map(QPointF(pyramid_[0].width(), 0));
  const double screenPerPixel =
      std::hypot(across.x() - origin.x(), across.y() - origin.y()) / pyramid_[0].width();
  std::size_t level = 0;
  for (double scale = screenPerPixel; scale <= 0.5 && level + 1 < pyramid_.size(); scale *= 2) ++level;
  const QImage& picture = pyramid_[level];

  // The calibration counts from the centre of the first pixel, painting from its corner.
  QTransform levelToPixel;
  levelToPixel.translate(-0.5, -0.5);
  levelToPixel.scale(double(pyramid_[0].width()) / picture.width(),
                     double(pyramid_[0].height()) / picture.height());
  const QTransform levelToScreen = levelToPixel * pixelToScreen;

  bool invertible = false;
  const QTransform screenToLevel = levelToScreen.inverted(&invertible);
  if (!invertible) return;
  const QRect visible =
      screenToLevel.mapRect(QRectF(rect)).toAlignedRect().adjusted(-1, -1, 1, 1).intersected(picture.rect());
  if (visible.isEmpty()) return;
  painter->save();
  painter->setClipRect(rect);
  painter->setOpacity(opacity_);
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  painter->setTransform(levelToScreen, true);
  painter->drawImage(visible, picture, visible);
  painter->restore();
}

}  // namespace detent::editor
