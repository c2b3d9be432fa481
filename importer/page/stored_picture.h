// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pixels as a picture file stores them, one decoder per format. Private to importer/page. The libraries' own
// limits are set from the size in the header, which has been checked against our limits
// (docs/develop/decisions/0301-input-limits.md).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace detent::importer {

/// 8 bits per channel, red green blue alpha, rows from the top as stored; alpha is not multiplied in.
struct StoredPicture {
  int width_px = 0, height_px = 0;
  bool hasAlpha = false;  ///< false: every alpha is 255
  std::vector<std::uint8_t> rgba;

  StoredPicture(int width, int height)
      : width_px(width),
        height_px(height),
        rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255) {}
  std::uint8_t* row(int y) {
    return rgba.data() + 4 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(y);
  }
  const std::uint8_t* at(int x, int y) const {
    return rgba.data() + 4 * (static_cast<std::size_t>(width_px) * static_cast<std::size_t>(y) +
                              static_cast<std::size_t>(x));
  }
};

/// nullopt if the bytes are damaged, or of another size than `width` x `height`. Palette, grey, 16 bits and
/// CMYK become RGB; neither gamma nor profile is applied.
std::optional<StoredPicture> decodePng(std::span<const unsigned char> bytes, int width, int height);
std::optional<StoredPicture> decodeJpeg(std::span<const unsigned char> bytes, int width, int height);
std::optional<StoredPicture> decodeBmp(std::span<const unsigned char> bytes, int width, int height);
/// Still pictures only; an animation gives nullopt.
std::optional<StoredPicture> decodeGif(std::span<const unsigned char> bytes, int width, int height);
std::optional<StoredPicture> decodeWebp(std::span<const unsigned char> bytes, int width, int height);
/// The picture whose directory stands at `directoryOffset`. Floating point is taken as 0..1.
std::optional<StoredPicture> decodeTiff(std::span<const unsigned char> bytes, int width, int height,
                                        std::size_t directoryOffset);

}  // namespace detent::importer
