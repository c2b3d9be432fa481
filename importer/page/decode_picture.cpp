// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/decode_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

namespace detent::importer {
namespace {

/// The decoder would print its own remarks on broken files to stderr.
void silenceDecoder() {
  static std::once_flag once;
  std::call_once(once, [] { cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT); });
}

/// TIFF decoders show the file's first picture: put this one first.
std::vector<unsigned char> withFirstDirectory(std::span<const unsigned char> bytes, std::size_t directory) {
  std::vector<unsigned char> copy(bytes.begin(), bytes.end());
  const bool bigEndian = copy[0] == 'M';
  const bool bigTiff = (bigEndian ? copy[3] : copy[2]) == 43;
  const std::size_t at = bigTiff ? 8 : 4, size = bigTiff ? 8 : 4;
  for (std::size_t i = 0; i < size; ++i)
    copy[bigEndian ? at + size - 1 - i : at + i] = static_cast<unsigned char>(directory >> (8 * i) & 0xff);
  return copy;
}

cv::Mat decodeStored(std::span<const unsigned char> bytes, FileKind kind, const PictureHeader& header) {
  silenceDecoder();
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return {};
  std::vector<unsigned char> patched;
  if (kind == FileKind::tiff) {
    patched = withFirstDirectory(bytes, header.directoryOffset);
    bytes = patched;
  }
  try {
    const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1,
                          const_cast<unsigned char*>(bytes.data()));
    return cv::imdecode(encoded, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

/// Whatever depth was stored, as 8 bits. Floating point pictures are taken as 0..1.
cv::Mat toEightBits(const cv::Mat& stored) {
  switch (stored.depth()) {
    case CV_8U:
      return stored;
    case CV_16U: {
      cv::Mat out;
      stored.convertTo(out, CV_8U, 1.0 / 257);
      return out;
    }
    case CV_32F:
    case CV_64F: {
      cv::Mat out, finite = stored.clone();
      cv::patchNaNs(finite, 0);
      finite.convertTo(out, CV_8U, 255.0);
      return out;
    }
    default:
      return {};
  }
}

struct Pixel {
  std::uint8_t r = 0, g = 0, b = 0, alpha = 255;
};

/// Reads any of the decoder's channel layouts: grey, BGR, BGRA.
class PixelReader {
 public:
  PixelReader(const cv::Mat& mat, const std::optional<Rgb>& transparentColor)
      : mat_(mat), channels_(mat.channels()), key_(transparentColor) {}

  bool transparent() const { return channels_ == 4 || key_; }
  Pixel at(int x, int y) const {
    const unsigned char* p = mat_.ptr(y) + static_cast<std::ptrdiff_t>(x) * channels_;
    Pixel out = channels_ >= 3 ? Pixel{p[2], p[1], p[0], 255} : Pixel{p[0], p[0], p[0], 255};
    if (channels_ == 4) out.alpha = p[3];
    if (key_ && key_->r == out.r && key_->g == out.g && key_->b == out.b) out.alpha = 0;
    return out;
  }

 private:
  const cv::Mat& mat_;
  int channels_;
  std::optional<Rgb> key_;
};

double luminance(const Pixel& p) { return 0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b; }

/// How much of an ink of this luminance vanishes on a background of that luminance, 0..1.
double vanishing(double ink, double background) {
  constexpr double justVisible = 16;  // grey levels
  const double contrast = (ink - background) / justVisible;
  return std::exp(-contrast * contrast);
}

/// Only ink that borders on transparency tells on which background the picture was meant to stand: letters
/// and axis lines, not the inside of an opaque white plot area.
bool bordersOnTransparency(const PixelReader& in, int x, int y, int width, int height) {
  constexpr int reach = 2;
  for (const auto& [dx, dy] : {std::pair{reach, 0}, {-reach, 0}, {0, reach}, {0, -reach}}) {
    const int nx = x + dx, ny = y + dy;
    if (nx >= 0 && ny >= 0 && nx < width && ny < height && in.at(nx, ny).alpha < 32) return true;
  }
  return false;
}

/// 255 or 0: white, unless more of the picture's ink would vanish on white than on black.
std::uint8_t backgroundFor(const PixelReader& in, int width, int height) {
  double lostOnWhite = 0, lostOnBlack = 0;
  const int step = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(width) * height / 4e6)));
  for (int y = 0; y < height; y += step)
    for (int x = 0; x < width; x += step) {
      const Pixel p = in.at(x, y);
      if (p.alpha < 128 || !bordersOnTransparency(in, x, y, width, height)) continue;
      const double ink = luminance(p);
      lostOnWhite += vanishing(ink, 255);
      lostOnBlack += vanishing(ink, 0);
    }
  return lostOnWhite > lostOnBlack ? 0 : 255;
}

bool allTransparent(const cv::Mat& bgra) {
  for (int y = 0; y < bgra.rows; ++y) {
    const unsigned char* row = bgra.ptr(y);
    for (int x = 0; x < bgra.cols; ++x)
      if (row[4 * x + 3] != 0) return false;
  }
  return true;
}

/// Where the pixel that is shown at (0,0) is stored, and how far to go per column and row. EXIF
/// orientation 1..8.
struct StoredOrder {
  bool swapped = false, flipX = false, flipY = false;
};

StoredOrder storedOrder(int orientation) {
  switch (orientation) {
    case 2:
      return {false, true, false};
    case 3:
      return {false, true, true};
    case 4:
      return {false, false, true};
    case 5:
      return {true, false, false};
    case 6:
      return {true, false, true};
    case 7:
      return {true, true, true};
    case 8:
      return {true, true, false};
    default:
      return {};
  }
}

std::uint8_t over(std::uint8_t ink, std::uint8_t alpha, std::uint8_t background) {
  const int mixed = ink * alpha + background * (255 - alpha);
  return static_cast<std::uint8_t>((mixed + 127) / 255);
}

Raster flattened(const cv::Mat& mat, const PictureHeader& header, bool ignoreAlpha) {
  const PixelReader in(mat, header.transparentColor);
  const StoredOrder order = storedOrder(header.decoderTurns ? 1 : header.orientation);
  const bool mix = in.transparent() && !ignoreAlpha;
  const std::uint8_t background = mix ? backgroundFor(in, mat.cols, mat.rows) : std::uint8_t{255};
  Raster out;
  out.width_px = order.swapped ? mat.rows : mat.cols;
  out.height_px = order.swapped ? mat.cols : mat.rows;
  out.rgb.resize(3 * static_cast<std::size_t>(out.width_px) * static_cast<std::size_t>(out.height_px));
  std::uint8_t* to = out.rgb.data();
  for (int y = 0; y < out.height_px; ++y)
    for (int x = 0; x < out.width_px; ++x, to += 3) {
      int sx = order.swapped ? y : x, sy = order.swapped ? x : y;
      if (order.flipX) sx = mat.cols - 1 - sx;
      if (order.flipY) sy = mat.rows - 1 - sy;
      const Pixel p = in.at(sx, sy);
      to[0] = mix ? over(p.r, p.alpha, background) : p.r;
      to[1] = mix ? over(p.g, p.alpha, background) : p.g;
      to[2] = mix ? over(p.b, p.alpha, background) : p.b;
    }
  return out;
}

}  // namespace

std::optional<Raster> decodePicture(std::span<const unsigned char> bytes, FileKind kind,
                                    const PictureHeader& header) {
  const cv::Mat mat = toEightBits(decodeStored(bytes, kind, header));
  if (mat.empty() || mat.channels() == 2 || mat.channels() > 4) return std::nullopt;
  const bool sameSize = mat.cols == header.width_px && mat.rows == header.height_px;
  const bool turnedSize = mat.cols == header.height_px && mat.rows == header.width_px;
  if (!sameSize && !(header.decoderTurns && turnedSize)) return std::nullopt;
  // 32-bit BMPs mostly leave the fourth byte 0 and mean opaque.
  const bool unusedAlpha = kind == FileKind::bmp && mat.channels() == 4 && allTransparent(mat);
  return flattened(mat, header, unusedAlpha);
}

}  // namespace detent::importer
