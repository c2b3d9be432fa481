// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include <webp/decode.h>

#include "importer/page/half_colour.h"
#include "importer/page/stored_picture.h"

namespace detent::importer {

namespace {

constexpr int kLossy = 1;  // WebPBitstreamFeatures::format

/// Lossy WebP stores BT.601's limited range: brightness 16 to 235, colour 224 levels wide.
std::uint8_t fullRange(int value, int zero, int width, int middle) {
  const double full = middle + (value - zero) * 255.0 / width;
  return static_cast<std::uint8_t>(std::clamp(std::lround(full), 0L, 255L));
}

/// Brightness, Cb and Cr as stored: one colour for 2 x 2 pixels.
bool readHalfColour(std::span<const unsigned char> bytes, StoredPicture& picture) {
  struct Free {
    void operator()(std::uint8_t* p) const { WebPFree(p); }
  };
  int width = 0, height = 0, stride = 0, colourStride = 0;
  std::uint8_t *cb = nullptr, *cr = nullptr;
  const std::unique_ptr<std::uint8_t, Free> bright(
      WebPDecodeYUV(bytes.data(), bytes.size(), &width, &height, &cb, &cr, &stride, &colourStride));
  if (!bright || width != picture.width_px || height != picture.height_px) return false;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = bright.get() + std::ptrdiff_t{y} * stride;
    const std::ptrdiff_t colourRow = std::ptrdiff_t{y / 2} * colourStride;
    std::uint8_t* to = picture.row(y);
    for (int x = 0; x < width; ++x, to += 4) {
      to[0] = fullRange(row[x], 16, 219, 0);
      to[1] = fullRange(cb[colourRow + x / 2], 128, 224, 128);
      to[2] = fullRange(cr[colourRow + x / 2], 128, 224, 128);
    }
  }
  return true;
}

}  // namespace

std::optional<StoredPicture> decodeWebp(std::span<const unsigned char> bytes, int width, int height) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) return {};
  if (features.width != width || features.height != height || features.has_animation != 0) return {};
  StoredPicture picture(width, height);
  picture.hasAlpha = features.has_alpha != 0;
  if (features.format == kLossy && !picture.hasAlpha) {
    if (!readHalfColour(bytes, picture)) return {};
    colourByBrightness(picture, {2, 2});
    return picture;
  }
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), picture.rgba.data(), picture.rgba.size(), 4 * width) ==
      nullptr)
    return {};
  return picture;
}

}  // namespace detent::importer
