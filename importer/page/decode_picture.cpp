// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/decode_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "importer/page/luma.h"
#include "importer/page/stored_picture.h"

namespace detent::importer {
namespace {

struct PicturePixel {
  std::uint8_t r = 0, g = 0, b = 0, alpha = 255;
};

PicturePixel pixelAt(const StoredPicture& picture, int x, int y) {
  const std::uint8_t* p = picture.at(x, y);
  return {p[0], p[1], p[2], p[3]};
}

double pixelLuma(const PicturePixel& p) { return importer::luma(p.r, p.g, p.b); }

/// Fraction of contrast lost when a foreground of this brightness is put on this background, 0..1.
double vanishing(double foreground, double background) {
  constexpr double justVisible = 16;  // grey levels
  const double contrast = (foreground - background) / justVisible;
  return std::exp(-contrast * contrast);
}

constexpr double kSoftRim = 6;  // grey levels between a line and its rim

struct Step {
  int dx = 0, dy = 0;
};

/// The step from a pixel onto a transparent neighbour; nullopt if there is none. Only letters and lines that
/// border on transparency show for which background the picture was made; the inside of an opaque white plot
/// area does not.
std::optional<Step> towardsTransparency(const StoredPicture& in, int x, int y) {
  constexpr int reach = 1;  // with 2, pixels behind a soft rim would count as part of the rim
  for (const Step step : {Step{reach, 0}, {-reach, 0}, {0, reach}, {0, -reach}}) {
    const int nx = x + step.dx, ny = y + step.dy;
    if (nx >= 0 && ny >= 0 && nx < in.width_px && ny < in.height_px && pixelAt(in, nx, ny).alpha < 32)
      return step;
  }
  return {};
}

/// Returns true if a plot's background lies behind a rim: one shade over more than the thickness of a line.
bool isBackground(const StoredPicture& in, int x, int y, Step outwards, double shade) {
  constexpr int thick = 12;  // px
  const int nx = x - thick * outwards.dx, ny = y - thick * outwards.dy;
  if (nx < 0 || ny < 0 || nx >= in.width_px || ny >= in.height_px) return false;
  const PicturePixel p = pixelAt(in, nx, ny);
  return p.alpha >= 128 && std::abs(pixelLuma(p) - shade) <= kSoftRim;
}

/// Brightness of the line or letter that a rim pixel belongs to: the nearby one that differs most from it.
double colourBehindRim(const StoredPicture& in, int x, int y) {
  constexpr int reach = 2;
  const double own = pixelLuma(pixelAt(in, x, y));
  double behind = own;
  for (int ny = std::max(0, y - reach); ny <= std::min(in.height_px - 1, y + reach); ++ny)
    for (int nx = std::max(0, x - reach); nx <= std::min(in.width_px - 1, x + reach); ++nx) {
      const PicturePixel p = pixelAt(in, nx, ny);
      if (p.alpha >= 128 && std::abs(pixelLuma(p) - own) > std::abs(behind - own)) behind = pixelLuma(p);
    }
  return behind;
}

/// Brightness of the background for transparent pixels: 255 (white), or 0 if white hides more of the lines.
std::uint8_t backgroundFor(const StoredPicture& in) {
  double lostOnWhite = 0, lostOnBlack = 0;
  const int step =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(in.width_px) * in.height_px / 4e6)));
  for (int y = 0; y < in.height_px; y += step)
    for (int x = 0; x < in.width_px; x += step) {
      const PicturePixel p = pixelAt(in, x, y);
      const auto outwards = p.alpha < 128 ? std::nullopt : towardsTransparency(in, x, y);
      if (!outwards) continue;
      const double own = pixelLuma(p), behind = colourBehindRim(in, x, y);
      const bool soft = std::abs(own - behind) > kSoftRim,
                 isBehind = isBackground(in, x, y, *outwards, behind);
      if (isBehind && !soft) continue;  // a plot's edge without a line
      if (soft && !isBehind) {
        // The picture was antialiased against a background that was removed later: its shade remains at the
        // rims of all lines.
        (own > behind ? lostOnBlack : lostOnWhite) += 1;
        continue;
      }
      const double foreground = isBehind ? own : behind;
      lostOnWhite += vanishing(foreground, 255);
      lostOnBlack += vanishing(foreground, 0);
    }
  return lostOnWhite > lostOnBlack ? 0 : 255;
}

/// Index of the stored pixel that is shown at (0,0), and steps per column and row. EXIF orientation 1..8.
struct StoredOrder {
  bool swapped = false, flipX = false, flipY = false;
};

constexpr StoredOrder storedOrders[] = {{},
                                        {},
                                        {false, true, false},
                                        {false, true, true},
                                        {false, false, true},
                                        {true, false, false},
                                        {true, false, true},
                                        {true, true, true},
                                        {true, true, false}};

std::uint8_t over(std::uint8_t foreground, std::uint8_t alpha, std::uint8_t background) {
  const int mixed = foreground * alpha + background * (255 - alpha);
  return static_cast<std::uint8_t>((mixed + 127) / 255);
}

bool isSeeThrough(const StoredPicture& in) {
  for (std::size_t i = 3; i < in.rgba.size(); i += 4)
    if (in.rgba[i] != 255) return true;
  return false;
}

/// Composes the picture onto its background within the memory of the stored picture, because a large picture
/// takes most of the memory.
Raster flattenedInPlace(StoredPicture in, bool opaque, std::uint8_t background) {
  const std::uint8_t* from = in.rgba.data();
  std::uint8_t* to = in.rgba.data();
  const std::size_t pixels = in.rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i, from += 4, to += 3) {
    const std::uint8_t alpha = from[3];
    for (int c = 0; c < 3; ++c) to[c] = opaque ? from[c] : over(from[c], alpha, background);
  }
  in.rgba.resize(3 * pixels);
  return {in.width_px, in.height_px, std::move(in.rgba)};
}

Raster flattened(StoredPicture in, int orientation) {
  const StoredOrder order = storedOrders[orientation];
  const bool opaque = !in.hasAlpha || !isSeeThrough(in);
  const std::uint8_t background = opaque ? std::uint8_t{255} : backgroundFor(in);
  if (!order.swapped && !order.flipX && !order.flipY)
    return flattenedInPlace(std::move(in), opaque, background);
  Raster out;
  out.width_px = order.swapped ? in.height_px : in.width_px;
  out.height_px = order.swapped ? in.width_px : in.height_px;
  out.rgb.resize(3 * static_cast<std::size_t>(out.width_px) * static_cast<std::size_t>(out.height_px));
  const std::ptrdiff_t alongX = order.flipX ? -4 : 4,
                       alongY = (order.flipY ? -4 : 4) * std::ptrdiff_t{in.width_px};
  const std::uint8_t* first = in.at(order.flipX ? in.width_px - 1 : 0, order.flipY ? in.height_px - 1 : 0);
  std::uint8_t* to = out.rgb.data();
  for (int y = 0; y < out.height_px; ++y) {
    const std::uint8_t* from = first + y * (order.swapped ? alongX : alongY);
    for (int x = 0; x < out.width_px; ++x, to += 3, from += order.swapped ? alongY : alongX)
      for (int c = 0; c < 3; ++c) to[c] = opaque ? from[c] : over(from[c], from[3], background);
  }
  return out;
}

std::optional<StoredPicture> decodeStored(std::span<const unsigned char> bytes, FileKind kind,
                                          const PictureHeader& header) {
  const int width = static_cast<int>(header.width_px), height = static_cast<int>(header.height_px);
  switch (kind) {
    case FileKind::png:
      return decodePng(bytes, width, height);
    case FileKind::jpeg:
      return decodeJpeg(bytes, width, height);
    case FileKind::bmp:
      return decodeBmp(bytes, width, height);
    case FileKind::gif:
      return decodeGif(bytes, width, height);
    case FileKind::webp:
      return decodeWebp(bytes, width, height);
    case FileKind::tiff:
      return decodeTiff(bytes, width, height, header.directoryOffset);
    default:
      return {};
  }
}

}  // namespace

std::optional<Raster> decodePicture(std::span<const unsigned char> bytes, FileKind kind,
                                    const PictureHeader& header) {
  constexpr long long mostPerSide = 1 << 20;
  if (header.width_px <= 0 || header.height_px <= 0 ||
      std::max(header.width_px, header.height_px) > mostPerSide)
    return std::nullopt;
  auto stored = decodeStored(bytes, kind, header);
  if (!stored) return std::nullopt;
  return flattened(std::move(*stored), header.orientation);
}

}  // namespace detent::importer
