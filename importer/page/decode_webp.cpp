// SPDX-License-Identifier: GPL-3.0-or-later
#include <webp/decode.h>

#include "importer/page/stored_picture.h"

namespace detent::importer {

std::optional<StoredPicture> decodeWebp(std::span<const unsigned char> bytes, int width, int height) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) return {};
  if (features.width != width || features.height != height || features.has_animation != 0) return {};
  StoredPicture picture(width, height);
  picture.hasAlpha = features.has_alpha != 0;
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), picture.rgba.data(), picture.rgba.size(), 4 * width) ==
      nullptr)
    return {};
  return picture;
}

}  // namespace detent::importer
