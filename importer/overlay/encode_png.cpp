// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/overlay/encode_png.h"

#include <csetjmp>

#include <png.h>

#include "model/check.h"

namespace detent::importer {
namespace {

// compression level of zlib's 9: files a few per cent larger in a third of the time
constexpr int quickLevel = 2;

void append(png_structp png, png_bytep bytes, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), size);
}

void flushed(png_structp) {}
[[noreturn]] void failed(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void ignored(png_structp, png_const_charp) {}

/// Writes the rows. libpng reports errors by longjmp, so objects with destructors are declared by the caller.
bool writeRows(png_structp png, png_infop info, const Raster& picture) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_compression_level(png, quickLevel);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width_px),
               static_cast<png_uint_32>(picture.height_px), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (int y = 0; y < picture.height_px; ++y)
    png_write_row(png, picture.rgb.data() +
                           3 * static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(y));
  png_write_end(png, info);
  return true;
}

}  // namespace

std::string pngBytes(const Raster& picture) {
  DETENT_CHECK(!picture.empty(), "a picture to encode has pixels");
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, failed, ignored);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  DETENT_CHECK(info != nullptr, "there is memory for a PNG encoder");
  png_set_write_fn(png, &bytes, append, flushed);
  const bool written = writeRows(png, info, picture);
  png_destroy_write_struct(&png, &info);
  DETENT_CHECK(written, "a picture in memory can be encoded");
  return bytes;
}

}  // namespace detent::importer
