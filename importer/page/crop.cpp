// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/crop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <opencv2/core.hpp>

#include "importer/page/quantile.h"
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

/// Catmull-Rom weights of four neighbouring pixels for a place at distance `t` behind the second.
std::array<double, 4> cubicWeights(double t) {
  return {t * (-0.5 + t * (1 - 0.5 * t)), 1 + t * t * (-2.5 + 1.5 * t), t * (0.5 + t * (2 - 1.5 * t)),
          t * t * (-0.5 + 0.5 * t)};
}

/// Median colour of the raster's border, per channel.
Rgb rimColor(const Raster& r) {
  std::array<std::vector<std::uint8_t>, 3> rim;
  const auto add = [&](int x, int y) {
    for (std::size_t c = 0; c < 3; ++c) rim[c].push_back(r.at(x, y)[c]);
  };
  for (int x = 0; x < r.width_px; ++x) add(x, 0), add(x, r.height_px - 1);
  for (int y = 0; y < r.height_px; ++y) add(0, y), add(r.width_px - 1, y);
  return {medianOf(rim[0]), medianOf(rim[1]), medianOf(rim[2])};
}

void sampleCubic(const Raster& source, Point at, std::uint8_t* out) {
  const double fx = std::floor(at.x), fy = std::floor(at.y);
  const auto wx = cubicWeights(at.x - fx), wy = cubicWeights(at.y - fy);
  std::array<double, 3> sum{};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int x = std::clamp(static_cast<int>(fx) + i - 1, 0, source.width_px - 1),
                y = std::clamp(static_cast<int>(fy) + j - 1, 0, source.height_px - 1);
      const double w = wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)];
      for (std::size_t c = 0; c < 3; ++c) sum[c] += w * source.at(x, y)[c];
    }
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = static_cast<std::uint8_t>(std::lround(std::clamp(sum[c], 0.0, 255.0)));
}

}  // namespace

Raster resampled(const Raster& source, const Homography& toSource, int width_px, int height_px) {
  DETENT_CHECK(!source.empty() && width_px > 0 && height_px > 0, "there are pixels to take and to fill");
  const Rgb around = rimColor(source);
  Raster out;
  out.width_px = width_px, out.height_px = height_px;
  out.rgb.resize(3 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  std::uint8_t* pixel = out.rgb.data();
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x, pixel += 3) {
      const Point at = toSource({static_cast<double>(x), static_cast<double>(y)});
      const bool inside =
          at.x > -0.5 && at.y > -0.5 && at.x < source.width_px - 0.5 && at.y < source.height_px - 0.5;
      if (inside)
        sampleCubic(source, at, pixel);
      else
        pixel[0] = around.r, pixel[1] = around.g, pixel[2] = around.b;
    }
  return out;
}

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
  out.rgb.resize(3 * static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height));
  const cv::Mat whole(raster.height_px, raster.width_px, CV_8UC3, const_cast<std::uint8_t*>(raster.at(0, 0)));
  const cv::Mat part = whole(cv::Rect(rect.x, rect.y, rect.width, rect.height));
  cv::Mat to(out.height_px, out.width_px, CV_8UC3, out.rgb.data());
  if (quarterTurns == 0)
    part.copyTo(to);
  else
    cv::rotate(part, to, cv::ROTATE_90_CLOCKWISE + quarterTurns - 1);
  return out;
}

Affine reducedCropToRaster(const PixelRect& rect, int factor) {
  const double middle = 0.5 * (factor - 1);
  return {static_cast<double>(factor), 0, 0, static_cast<double>(factor), rect.x + middle, rect.y + middle};
}

Raster reducedCrop(const Raster& raster, const PixelRect& rect, int factor) {
  DETENT_CHECK(factor > 0, "pixels are averaged, not invented");
  Raster out;
  out.width_px = (rect.width + factor - 1) / factor;
  out.height_px = (rect.height + factor - 1) / factor;
  const std::size_t rowBytes = 3 * static_cast<std::size_t>(out.width_px);
  out.rgb.resize(rowBytes * static_cast<std::size_t>(out.height_px));
  std::vector<int> sums(rowBytes);
  const auto columnsFrom = [&](int left) { return std::min(factor, rect.width - left); };
  for (int top = 0; top < rect.height; top += factor) {
    const int rows = std::min(factor, rect.height - top);
    std::uint8_t* to = out.rgb.data() + rowBytes * static_cast<std::size_t>(top / factor);
    if (factor == 1) {
      std::memcpy(to, raster.at(rect.x, rect.y + top), rowBytes);
      continue;
    }
    std::fill(sums.begin(), sums.end(), 0);
    for (int y = top; y < top + rows; ++y) {
      const std::uint8_t* from = raster.at(rect.x, rect.y + y);
      int* sum = sums.data();
      for (int left = 0; left < rect.width; left += factor, sum += 3)
        for (int i = columnsFrom(left); i > 0; --i, from += 3)
          sum[0] += from[0], sum[1] += from[1], sum[2] += from[2];
    }
    const int* sum = sums.data();
    for (int left = 0; left < rect.width; left += factor) {
      const int count = rows * columnsFrom(left);
      for (int c = 0; c < 3; ++c) *to++ = static_cast<std::uint8_t>((*sum++ + count / 2) / count);
    }
  }
  return out;
}

}  // namespace detent::importer
