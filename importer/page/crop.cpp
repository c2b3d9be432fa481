// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/crop.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "model/check.h"

namespace detent::importer {
namespace {

struct Span {
  int first = 0, last = -1;
};

Span touched(double low, double high, int size) {
  const double first = std::max(0.0, std::floor(low + 0.5));
  const double last = std::min(static_cast<double>(size - 1), std::ceil(high - 0.5));
  if (!(first <= last)) return {};
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

std::optional<PixelRect> touchedPixels(const Box& region, int width_px, int height_px) {
  const Span columns = touched(region.x0, region.x1, width_px);
  const Span rows = touched(region.y0, region.y1, height_px);
  if (columns.last < columns.first || rows.last < rows.first) return std::nullopt;
  return PixelRect{columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
}

Affine turnedCropToRaster(const PixelRect& rect, int quarterTurns) {
  const double left = rect.x, top = rect.y;
  const double right = rect.x + rect.width - 1, bottom = rect.y + rect.height - 1;
  switch (quarterTurns) {
    case 1:
      return {0, -1, 1, 0, left, bottom};
    case 2:
      return {-1, 0, 0, -1, right, bottom};
    case 3:
      return {0, 1, -1, 0, right, top};
    default:
      return {1, 0, 0, 1, left, top};
  }
}

Raster turnedCrop(const Raster& raster, const PixelRect& rect, int quarterTurns) {
  DETENT_CHECK(rect.x >= 0 && rect.y >= 0 && rect.width > 0 && rect.height > 0 &&
                   rect.x + rect.width <= raster.width_px && rect.y + rect.height <= raster.height_px,
               "a crop lies inside its raster");
  DETENT_CHECK(quarterTurns >= 0 && quarterTurns <= 3, "quarter turns are 0 to 3");
  const bool lying = quarterTurns % 2 == 1;
  Raster out;
  out.width_px = lying ? rect.height : rect.width;
  out.height_px = lying ? rect.width : rect.height;
  const std::size_t rowBytes = 3 * static_cast<std::size_t>(out.width_px);
  out.rgb.resize(rowBytes * static_cast<std::size_t>(out.height_px));
  if (quarterTurns == 0) {
    for (int y = 0; y < rect.height; ++y)
      std::memcpy(out.rgb.data() + rowBytes * static_cast<std::size_t>(y), raster.at(rect.x, rect.y + y),
                  rowBytes);
    return out;
  }
  const Affine map = turnedCropToRaster(rect, quarterTurns);
  const int stepX = static_cast<int>(map.a), stepY = static_cast<int>(map.b);
  std::uint8_t* to = out.rgb.data();
  for (int y = 0; y < out.height_px; ++y) {
    const Point start = map({0, static_cast<double>(y)});
    int fromX = static_cast<int>(start.x), fromY = static_cast<int>(start.y);
    for (int x = 0; x < out.width_px; ++x, to += 3, fromX += stepX, fromY += stepY)
      std::memcpy(to, raster.at(fromX, fromY), 3);
  }
  return out;
}

}  // namespace detent::importer
