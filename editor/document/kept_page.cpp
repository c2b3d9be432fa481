// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/document/kept_page.h"

#include <algorithm>
#include <cmath>
#include <QBuffer>
#include <string>

#include "model/units.h"

namespace detent::editor {
namespace {

constexpr int largestSide_px = 2000, leastSide_px = 320;  // below that a curve is not recognisable
// factor of the picture's sides, after which a PNG has about half the bytes
constexpr double nextSmaller = 0.75;

/// Reduced to at most that side; pixels keep their position on the axes.
PlacedPage within(const PlacedPage& page, int side_px) {
  if (std::max(page.picture.width(), page.picture.height()) <= side_px) return page;
  const QImage smaller = page.picture.scaled(side_px, side_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  const double x = double(page.picture.width()) / smaller.width(),
               y = double(page.picture.height()) / smaller.height();
  const QTransform toWhole(x, 0, 0, y, 0.5 * (x - 1), 0.5 * (y - 1));
  return {smaller, toWhole * page.pixelToAxes, page.readable};
}

std::string pngOf(const QImage& picture) {
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  constexpr int smallFile = 10;  // quality, of 100: a low one gives a small file
  if (!picture.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG", smallFile)) return {};
  return png.toStdString();
}

// Qt uses row vectors, the file column vectors.
std::array<double, 9> numbersOf(const QTransform& t) {
  return {t.m11(), t.m21(), t.m31(), t.m12(), t.m22(), t.m32(), t.m13(), t.m23(), t.m33()};
}

}  // namespace

std::optional<PageCutout> cutoutOf(const PlacedPage& page) {
  for (double side_px = largestSide_px; side_px >= leastSide_px; side_px *= nextSmaller) {
    const PlacedPage smaller = within(page, static_cast<int>(side_px));
    std::string png = pngOf(smaller.picture);
    if (!png.empty() && png.size() <= largestCutout_bytes)
      return PageCutout{std::move(png), numbersOf(smaller.pixelToAxes)};
  }
  return {};
}

std::optional<PlacedPage> placedFrom(const PageCutout& cutout) {
  QImage picture;
  if (!picture.loadFromData(QByteArray::fromStdString(cutout.png), "PNG")) return {};
  return PlacedPage{std::move(picture), transformOf(cutout.pixelToAxes), false};
}

std::optional<QRectF> frameOf(const Provenance& from) {
  if (!from.xAxis || !from.yAxis) return {};
  const auto length = lengthUnitFrom(from.xAxis->unit);
  const auto force = forceUnitFrom(from.yAxis->unit);
  if (!length || !force) return {};
  const double mm = millimetresPer(*length), N = newtonsPer(*force);
  const QRectF span(QPointF(mm * from.xAxis->min, N * from.yAxis->min),
                    QPointF(mm * from.xAxis->max, N * from.yAxis->max));
  return span.isEmpty() ? std::nullopt : std::optional(span);
}

}  // namespace detent::editor
