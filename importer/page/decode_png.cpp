// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>

#include "importer/page/stored_picture.h"

namespace detent::importer {

std::optional<StoredPicture> decodePng(std::span<const unsigned char> bytes, int width, int height) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return {};
  if (png.width != static_cast<png_uint_32>(width) || png.height != static_cast<png_uint_32>(height)) {
    png_image_free(&png);
    return {};
  }
  StoredPicture picture(width, height);
  picture.hasAlpha = (png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  png.format = PNG_FORMAT_RGBA;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16-bit values have the same gamma as 8-bit ones
  if (png_image_finish_read(&png, nullptr, picture.rgba.data(), 0, nullptr) == 0) return {};
  return picture;
}

}  // namespace detent::importer
