// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csetjmp>
#include <cstring>

#include <png.h>

#include "importer/page/stored_picture.h"

namespace detent::importer {
namespace {

struct UnreadPng {
  std::span<const unsigned char> bytes;
};

void readPngBytes(png_structp png, png_bytep to, std::size_t size) {
  auto& unread = *static_cast<UnreadPng*>(png_get_io_ptr(png));
  if (size > unread.bytes.size()) png_error(png, "ends early");
  std::memcpy(to, unread.bytes.data(), size);
  unread.bytes = unread.bytes.subspan(size);
}

[[noreturn]] void pngFailed(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignorePngWarning(png_structp, png_const_charp) {}

/// What a jump back must not skip the destructors of stands outside. libpng reports by longjmp.
bool readPngRows(png_structp png, png_infop info, StoredPicture& picture, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_info(png, info);
  if (png_get_image_width(png, info) != static_cast<png_uint_32>(picture.width_px) ||
      png_get_image_height(png, info) != static_cast<png_uint_32>(picture.height_px))
    return false;
  picture.hasAlpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                     png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  png_set_expand(png);  // palettes, small depths, colour keys
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != 4 * static_cast<std::size_t>(picture.width_px)) return false;
  png_read_image(png, rows.data());
  return true;
}

}  // namespace

std::optional<StoredPicture> decodePng(std::span<const unsigned char> bytes, int width, int height) {
  constexpr png_alloc_size_t mostPerChunk = png_alloc_size_t{16} << 20;  // remarks and profiles need far less
  StoredPicture picture(width, height);
  std::vector<png_bytep> rows;
  for (int y = 0; y < height; ++y) rows.push_back(picture.row(y));
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, pngFailed, ignorePngWarning);
  if (png == nullptr) return {};
  png_infop info = png_create_info_struct(png);
  UnreadPng unread{bytes};
  png_set_read_fn(png, &unread, readPngBytes);
  png_set_user_limits(png, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height));
  png_set_chunk_malloc_max(png, mostPerChunk);
  const bool read = info != nullptr && readPngRows(png, info, picture, rows);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!read) return {};
  return picture;
}

}  // namespace detent::importer
