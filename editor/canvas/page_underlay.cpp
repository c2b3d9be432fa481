// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/page_underlay.h"

#include <algorithm>
#include <cmath>

namespace detent::editor {
namespace {

// The same shift on all three channels exchanges the lightest and the darkest and keeps the hue.
QImage lightnessInverted(const QImage& page) {
  QImage inverted = page.copy();
  for (int y = 0; y < inverted.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(inverted.scanLine(y));
    for (int x = 0; x < inverted.width(); ++x) {
      const int r = qRed(line[x]), g = qGreen(line[x]), b = qBlue(line[x]);
      const int shift = 255 - std::max({r, g, b}) - std::min({r, g, b});
      line[x] = qRgb(r + shift, g + shift, b + shift);
    }
  }
  return inverted;
}

}  // namespace

PageUnderlay::PageUnderlay(UnitPlot& plot) : QCPLayerable(&plot, QStringLiteral("background")), plot_(plot) {}

void PageUnderlay::setPage(const QImage& page, const QTransform& pixelToAxes) {
  pixelToAxes_ = pixelToAxes;
  page_ = page.convertToFormat(QImage::Format_RGB32);
  build();
}

void PageUnderlay::setDarkPaper(bool dark) {
  if (dark == darkPaper_) return;
  darkPaper_ = dark;
  build();
}

void PageUnderlay::build() {
  pyramid_.clear();
  if (page_.isNull()) return;
  pyramid_.push_back(darkPaper_ ? lightnessInverted(page_) : page_);
  constexpr int smallest_px = 256;
  while (pyramid_.back().width() > smallest_px && pyramid_.back().height() > smallest_px) {
    const QImage& last = pyramid_.back();
    pyramid_.push_back(
        last.scaled(last.width() / 2, last.height() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  }
}

void PageUnderlay::clear() {
  page_ = {};
  pyramid_.clear();
}

void PageUnderlay::setOpacity(double opacity) { opacity_ = std::clamp(opacity, 0.0, 1.0); }

// QCustomPlot shifts antialiased drawing by half a pixel, which PlotMapping includes already.
void PageUnderlay::applyDefaultAntialiasingHint(QCPPainter* painter) const {
  applyAntialiasingHint(painter, false, QCP::aeOther);
}

QRect PageUnderlay::clipRect() const { return plot_.axisRect()->rect(); }

void PageUnderlay::draw(QCPPainter* painter) { paint(*painter, plot_.mapping()); }

void PageUnderlay::paint(QPainter& painter, const PlotMapping& map) const {
  if (pyramid_.empty() || opacity_ <= 0) return;
  const QTransform pixelToScreen = pixelToAxes_ * map.transform();

  // Half-size copies as far as the device's pixels allow.
  const QPointF origin = pixelToScreen.map(QPointF(0, 0));
  const QPointF across = pixelToScreen.map(QPointF(pyramid_[0].width(), 0));
  const double screenPerPixel = painter.device()->devicePixelRatioF() *
                                std::hypot(across.x() - origin.x(), across.y() - origin.y()) /
                                pyramid_[0].width();
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
      screenToLevel.mapRect(map.clip_px).toAlignedRect().adjusted(-1, -1, 1, 1).intersected(picture.rect());
  if (visible.isEmpty()) return;
  painter.save();
  constexpr double lineOfFrame_px = 2;
  painter.setClipRect(map.clip_px, Qt::IntersectClip);
  if (!frame_.isEmpty())
    painter.setClipRect(map.transform().mapRect(frame_).adjusted(-lineOfFrame_px, -lineOfFrame_px,
                                                                 lineOfFrame_px, lineOfFrame_px),
                        Qt::IntersectClip);
  painter.setOpacity(opacity_);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setTransform(levelToScreen, true);
  painter.drawImage(visible, picture, visible);
  painter.restore();
}

}  // namespace detent::editor
