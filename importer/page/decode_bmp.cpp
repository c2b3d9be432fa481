// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes BMP with MuPDF.

#include <algorithm>

#include "importer/page/mupdf_context.h"
#include "importer/page/page_source.h"
#include "importer/page/stored_picture.h"

namespace detent::importer {
namespace {

/// Copies MuPDF's pixels and divides their colours by alpha.
void takePixels(const unsigned char* samples, std::ptrdiff_t stride, StoredPicture& picture) {
  for (int y = 0; y < picture.height_px; ++y) {
    std::copy_n(samples + stride * y, 4 * static_cast<std::size_t>(picture.width_px), picture.row(y));
    for (std::uint8_t *p = picture.row(y), *end = p + std::ptrdiff_t{4} * picture.width_px; p < end; p += 4) {
      picture.hasAlpha = picture.hasAlpha || p[3] != 255;
      for (int c = 0; p[3] > 0 && c < 3; ++c)
        p[c] = static_cast<std::uint8_t>(std::min(255, (p[c] * 255 + p[3] / 2) / p[3]));
    }
  }
}

}  // namespace

OpenedSource openBmpSource(const SourceFile& file) { return openPictureSource(file); }

std::optional<StoredPicture> decodeBmp(std::span<const unsigned char> bytes, int width, int height) {
  StoredPicture picture(width, height);
  constexpr std::size_t others = std::size_t{64} << 20;  // bytes, beyond the file and its pixels
  const MupdfContext owner(bytes.size() + 2 * picture.rgba.size() + others);
  fz_context* const context = owner.get();
  if (context == nullptr) return {};
  fz_buffer* buffer = nullptr;
  fz_image* image = nullptr;
  fz_pixmap* pixels = nullptr;
  std::string ignored;
  const bool read = guarded(context, ignored, [&] {
    buffer = fz_new_buffer_from_copied_data(context, bytes.data(), bytes.size());
    image = fz_new_image_from_buffer(context, buffer);
    if (image->w == width && image->h == height)
      pixels = fz_get_pixmap_from_image(context, image, nullptr, nullptr, nullptr, nullptr);
  });
  const bool usable = read && pixels != nullptr && fz_pixmap_components(context, pixels) == 4;
  if (usable) takePixels(fz_pixmap_samples(context, pixels), fz_pixmap_stride(context, pixels), picture);
  fz_drop_pixmap(context, pixels);
  fz_drop_image(context, image);
  fz_drop_buffer(context, buffer);
  if (!usable) return {};
  return picture;
}

}  // namespace detent::importer
