// SPDX-License-Identifier: GPL-3.0-or-later
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include "importer/page/half_colour.h"
#include "importer/page/stored_picture.h"

namespace detent::importer {
namespace {

struct ErrorExit {
  // the first member, because libjpeg's pointer to it is converted to a pointer to this struct
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

[[noreturn]] void jpegFailed(j_common_ptr jpeg) {
  std::longjmp(reinterpret_cast<ErrorExit*>(jpeg->err)->back, 1);
}
void ignoreJpegMessage(j_common_ptr) {}
void ignoredLevel(j_common_ptr, int) {}

/// Converts a row of Adobe's CMYK, which is stored inverted: colour and black are multiplied.
void fromCmyk(const JSAMPLE* from, std::uint8_t* to, int width) {
  for (int x = 0; x < width; ++x, from += 4, to += 4)
    for (int c = 0; c < 3; ++c) to[c] = static_cast<std::uint8_t>(from[c] * from[3] / 255);
}

void fromRgb(const JSAMPLE* from, std::uint8_t* to, int width) {
  for (int x = 0; x < width; ++x, from += 3, to += 4) to[0] = from[0], to[1] = from[1], to[2] = from[2];
}

/// The block of pixels that share one colour (4:2:0, 4:2:2), if there is more than one pixel and no more than
/// a view averages anyway (docs/develop/decisions/0300-page-views-and-large-pictures.md).
std::optional<ColourBlock> sharedColour(const jpeg_decompress_struct& jpeg) {
  constexpr double averaged_px = 16e6;
  if (jpeg.jpeg_color_space != JCS_YCbCr || jpeg.num_components != 3) return {};
  if (static_cast<double>(jpeg.image_width) * jpeg.image_height > averaged_px) return {};
  const jpeg_component_info *bright = jpeg.comp_info, *cb = bright + 1, *cr = bright + 2;
  const auto whole = [](const jpeg_component_info* c) {
    return c->h_samp_factor == 1 && c->v_samp_factor == 1;
  };
  if (!whole(cb) || !whole(cr) || bright->h_samp_factor != 2 || bright->v_samp_factor > 2) return {};
  return ColourBlock{bright->h_samp_factor, bright->v_samp_factor};
}

/// libjpeg reports errors by longjmp, so objects with destructors belong to the caller.
bool readJpegRows(jpeg_decompress_struct& jpeg, ErrorExit& error, std::span<const unsigned char> bytes,
                  StoredPicture& picture, std::vector<JSAMPLE>& line, std::optional<ColourBlock>& shared) {
  if (setjmp(error.back) != 0) return false;
  jpeg_mem_src(&jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&jpeg, TRUE);
  if (jpeg.image_width != static_cast<JDIMENSION>(picture.width_px) ||
      jpeg.image_height != static_cast<JDIMENSION>(picture.height_px))
    return false;
  const bool cmyk = jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK;
  shared = sharedColour(jpeg);
  jpeg.out_color_space = cmyk ? JCS_CMYK : shared ? JCS_YCbCr : JCS_RGB;
  if (shared) jpeg.do_fancy_upsampling = FALSE;  // colour as stored, one for each block
  jpeg_start_decompress(&jpeg);
  while (jpeg.output_scanline < jpeg.output_height) {
    std::uint8_t* to = picture.row(static_cast<int>(jpeg.output_scanline));
    JSAMPROW row = line.data();
    if (jpeg_read_scanlines(&jpeg, &row, 1) != 1) return false;
    cmyk ? fromCmyk(row, to, picture.width_px) : fromRgb(row, to, picture.width_px);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

}  // namespace

std::optional<StoredPicture> decodeJpeg(std::span<const unsigned char> bytes, int width, int height) {
  StoredPicture picture(width, height);
  std::vector<JSAMPLE> line(4 * static_cast<std::size_t>(width));
  jpeg_decompress_struct jpeg{};
  ErrorExit error{};
  jpeg.err = jpeg_std_error(&error.manager);
  error.manager.error_exit = jpegFailed;
  error.manager.output_message = ignoreJpegMessage;
  error.manager.emit_message = ignoredLevel;
  jpeg_create_decompress(&jpeg);
  std::optional<ColourBlock> shared;
  const bool read = readJpegRows(jpeg, error, bytes, picture, line, shared);
  jpeg_destroy_decompress(&jpeg);
  if (!read) return {};
  if (shared) colourByBrightness(picture, *shared);
  return picture;
}

}  // namespace detent::importer
