// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <mutex>

#include <tiffio.h>

#include "importer/page/stored_picture.h"

namespace detent::importer {
namespace {

/// A file in memory for libtiff's callbacks.
struct Source {
  std::span<const unsigned char> bytes;
  std::uint64_t at = 0;
};

tmsize_t readTiffBytes(thandle_t handle, void* to, tmsize_t size) {
  auto& source = *static_cast<Source*>(handle);
  if (size <= 0 || source.at >= source.bytes.size()) return 0;
  const std::size_t n =
      std::min(static_cast<std::size_t>(size), source.bytes.size() - static_cast<std::size_t>(source.at));
  std::memcpy(to, source.bytes.data() + source.at, n);
  source.at += n;
  return static_cast<tmsize_t>(n);
}

tmsize_t writeNothing(thandle_t, void*, tmsize_t) { return 0; }

toff_t seekTo(thandle_t handle, toff_t offset, int whence) {
  auto& source = *static_cast<Source*>(handle);
  source.at = whence == SEEK_CUR   ? source.at + offset
              : whence == SEEK_END ? source.bytes.size() + offset
                                   : offset;
  return source.at;
}

int closeNothing(thandle_t) { return 0; }
toff_t sizeOf(thandle_t handle) { return static_cast<Source*>(handle)->bytes.size(); }

/// Otherwise libtiff prints messages about broken files to stderr.
void silence() {
  static std::once_flag once;
  std::call_once(once, [] {
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
  });
}

std::uint8_t level(float value) {
  return static_cast<std::uint8_t>(
      std::lround(255 * std::clamp(std::isfinite(value) ? value : 0.0F, 0.0F, 1.0F)));
}

/// Reads 32-bit floating point, grey or RGB, stored in lines, which libtiff's own conversion cannot read.
bool readFloats(TIFF* tiff, StoredPicture& picture, int channels) {
  if (TIFFIsTiled(tiff) != 0) return false;
  const std::size_t values = static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(channels);
  if (TIFFScanlineSize(tiff) != static_cast<tmsize_t>(values * sizeof(float))) return false;
  std::vector<float> line(values);
  for (int y = 0; y < picture.height_px; ++y) {
    if (TIFFReadScanline(tiff, line.data(), static_cast<std::uint32_t>(y)) < 0) return false;
    std::uint8_t* to = picture.row(y);
    for (int x = 0; x < picture.width_px; ++x, to += 4)
      for (int c = 0; c < 3; ++c)
        to[c] = level(line[static_cast<std::size_t>(x * channels + (channels == 1 ? 0 : c))]);
  }
  return true;
}

/// Divides by alpha, because libtiff multiplies it in.
void takeAlphaOut(StoredPicture& picture) {
  for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    const int alpha = picture.rgba[i + 3];
    for (std::size_t c = i; alpha > 0 && alpha < 255 && c < i + 3; ++c)
      picture.rgba[c] = static_cast<std::uint8_t>(std::min(255, (picture.rgba[c] * 255 + alpha / 2) / alpha));
  }
}

bool readPixels(TIFF* tiff, StoredPicture& picture) {
  std::uint32_t width = 0, height = 0;
  std::uint16_t format = SAMPLEFORMAT_UINT, bits = 1, channels = 1, planes = PLANARCONFIG_CONTIG,
                orientation = 1;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &channels);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &planes);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &orientation);
  if (width != static_cast<std::uint32_t>(picture.width_px) ||
      height != static_cast<std::uint32_t>(picture.height_px))
    return false;
  if (format == SAMPLEFORMAT_IEEEFP)
    return bits == 32 && (channels == 1 || channels == 3) && planes == PLANARCONFIG_CONTIG &&
           readFloats(tiff, picture, channels);
  std::vector<std::uint32_t> raster(static_cast<std::size_t>(width) * height);
  // The file's own orientation gives the rows as stored. They are rotated later, as in all other formats.
  if (TIFFReadRGBAImageOriented(tiff, width, height, raster.data(), orientation, 1) == 0) return false;
  std::uint8_t* to = picture.rgba.data();
  for (const std::uint32_t pixel : raster) {
    *to++ = static_cast<std::uint8_t>(TIFFGetR(pixel));
    *to++ = static_cast<std::uint8_t>(TIFFGetG(pixel));
    *to++ = static_cast<std::uint8_t>(TIFFGetB(pixel));
    picture.hasAlpha = picture.hasAlpha || TIFFGetA(pixel) != 255;
    *to++ = static_cast<std::uint8_t>(TIFFGetA(pixel));
  }
  if (picture.hasAlpha) takeAlphaOut(picture);
  return true;
}

struct Close {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

}  // namespace

std::optional<StoredPicture> decodeTiff(std::span<const unsigned char> bytes, int width, int height,
                                        std::size_t directoryOffset) {
  silence();
  Source source{bytes, 0};
  const std::unique_ptr<TIFF, Close> tiff(TIFFClientOpen(
      "picture", "rm", &source, readTiffBytes, writeNothing, seekTo, closeNothing, sizeOf, nullptr, nullptr));
  if (!tiff || TIFFSetSubDirectory(tiff.get(), directoryOffset) == 0) return {};
  StoredPicture picture(width, height);
  if (!readPixels(tiff.get(), picture)) return {};
  return picture;
}

}  // namespace detent::importer
