// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>

#include "importer/page/stored_picture.h"

namespace detent::importer {
namespace {

enum Compression : std::uint32_t { none = 0, runs8 = 1, runs4 = 2, masks = 3, masksAndAlpha = 6 };

using BmpColor = std::array<std::uint8_t, 3>;

/// Little-endian numbers; what lies outside reads as 0.
class Bytes {
 public:
  explicit Bytes(std::span<const unsigned char> bytes) : bytes_(bytes) {}
  std::uint32_t u8(std::size_t at) const { return at < bytes_.size() ? bytes_[at] : 0; }
  std::uint32_t u16(std::size_t at) const { return u8(at) | u8(at + 1) << 8; }
  std::uint32_t u32(std::size_t at) const { return u16(at) | u16(at + 2) << 16; }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::span<const unsigned char> bytes_;
};

/// What the header says of the pixels.
struct Layout {
  std::size_t pixelsAt = 0;
  std::uint32_t bits = 0, compression = none;
  bool fromTop = false;
  std::vector<BmpColor> palette;
  std::array<std::uint32_t, 4> mask{};  // red, green, blue, alpha
};

std::array<std::uint32_t, 4> usualMasks(std::uint32_t bits) {
  if (bits == 16) return {0x7C00, 0x03E0, 0x001F, 0};
  return {0xFF0000, 0xFF00, 0xFF, bits == 32 ? 0xFF000000 : 0};
}

std::vector<BmpColor> paletteOf(const Bytes& in, std::size_t at, std::uint32_t bits, std::uint32_t used,
                                std::size_t stride) {
  const std::uint32_t all = 1U << bits, count = used == 0 ? all : std::min(used, all);
  std::vector<BmpColor> palette(all, BmpColor{});
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::size_t entry = at + k * stride;
    palette[k] = {static_cast<std::uint8_t>(in.u8(entry + 2)), static_cast<std::uint8_t>(in.u8(entry + 1)),
                  static_cast<std::uint8_t>(in.u8(entry))};
  }
  return palette;
}

Layout layoutOf(const Bytes& in) {
  Layout out;
  out.pixelsAt = in.u32(10);
  const std::uint32_t head = in.u32(14);
  const bool old = head == 12;
  out.bits = in.u16(old ? 24 : 28);
  out.compression = old ? none : in.u32(30);
  out.fromTop = !old && (in.u32(22) & 0x80000000U) != 0;
  out.mask = usualMasks(out.bits);
  const bool masked = out.compression == masks || out.compression == masksAndAlpha;
  for (std::size_t c = 0; masked && c < 4; ++c)
    out.mask[c] = c < 3 || head >= 56 || out.compression == masksAndAlpha ? in.u32(54 + 4 * c) : 0;
  const std::size_t behindMasks = masked && head == 40 ? (out.compression == masks ? 12 : 16) : 0;
  if (out.bits <= 8)
    out.palette = paletteOf(in, 14 + head + behindMasks, out.bits, old ? 0 : in.u32(46), old ? 3 : 4);
  return out;
}

std::uint8_t channel(std::uint32_t pixel, std::uint32_t mask) {
  if (mask == 0) return 0;
  const std::uint32_t most = mask >> std::countr_zero(mask);
  return static_cast<std::uint8_t>(((pixel & mask) >> std::countr_zero(mask)) * std::uint64_t{255} / most);
}

void setIndexed(StoredPicture& picture, const Layout& layout, int x, int y, std::uint32_t index) {
  if (x >= picture.width_px || index >= layout.palette.size()) return;
  std::copy(layout.palette[index].begin(), layout.palette[index].end(),
            picture.row(y) + 4 * static_cast<std::size_t>(x));
}

void readPlainRow(const Bytes& in, std::size_t at, const Layout& layout, StoredPicture& picture, int y) {
  const std::uint32_t bits = layout.bits;
  std::uint8_t* to = picture.row(y);
  for (int x = 0; x < picture.width_px; ++x, to += 4) {
    const std::size_t bit = static_cast<std::size_t>(x) * bits, byte = at + bit / 8;
    if (bits <= 8) {
      const std::uint32_t shift = 8 - bits - static_cast<std::uint32_t>(bit % 8);
      setIndexed(picture, layout, x, y, in.u8(byte) >> shift & ((1U << bits) - 1));
      continue;
    }
    const std::uint32_t pixel = bits == 16   ? in.u16(byte)
                                : bits == 24 ? in.u16(byte) | in.u8(byte + 2) << 16
                                             : in.u32(byte);
    for (std::size_t c = 0; c < 3; ++c) to[c] = channel(pixel, layout.mask[c]);
    if (layout.mask[3] != 0) to[3] = channel(pixel, layout.mask[3]);
  }
}

/// Run lengths: pairs of count and index; a count of 0 ends a line (0), the picture (1), moves on (2) or starts a
/// literal stretch. What is skipped keeps index 0.
bool readRuns(const Bytes& in, const Layout& layout, StoredPicture& picture) {
  const bool nibbles = layout.compression == runs4;
  const auto rowOf = [&](int line) { return layout.fromTop ? line : picture.height_px - 1 - line; };
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) setIndexed(picture, layout, x, y, 0);
  int x = 0, line = 0;
  for (std::size_t at = layout.pixelsAt; at + 1 < in.size() && line < picture.height_px;) {
    const std::uint32_t count = in.u8(at), value = in.u8(at + 1);
    at += 2;
    if (count > 0) {
      for (std::uint32_t k = 0; k < count && x < picture.width_px; ++k, ++x)
        setIndexed(picture, layout, x, rowOf(line), !nibbles ? value : k % 2 == 0 ? value >> 4 : value & 15);
    } else if (value == 0) {
      x = 0, ++line;
    } else if (value == 1) {
      return true;
    } else if (value == 2) {
      x += static_cast<int>(in.u8(at)), line += static_cast<int>(in.u8(at + 1));
      at += 2;
    } else {
      for (std::uint32_t k = 0; k < value && x < picture.width_px; ++k, ++x) {
        const std::uint32_t byte = in.u8(at + (nibbles ? k / 2 : k));
        setIndexed(picture, layout, x, rowOf(line), !nibbles ? byte : k % 2 == 0 ? byte >> 4 : byte & 15);
      }
      const std::size_t length = nibbles ? (value + 1) / 2 : value;
      at += length + length % 2;
    }
  }
  return line >= picture.height_px - 1;  // some writers leave the end mark out
}

bool supported(const Layout& layout) {
  const std::uint32_t b = layout.bits;
  switch (layout.compression) {
    case none:
      return b == 1 || b == 2 || b == 4 || b == 8 || b == 16 || b == 24 || b == 32;
    case runs8:
      return b == 8;
    case runs4:
      return b == 4;
    case masks:
    case masksAndAlpha:
      return b == 16 || b == 32;
    default:
      return false;
  }
}

}  // namespace

std::optional<StoredPicture> decodeBmp(std::span<const unsigned char> bytes, int width, int height) {
  const Bytes in(bytes);
  const Layout layout = layoutOf(in);
  if (!supported(layout)) return {};
  StoredPicture picture(width, height);
  if (layout.compression == runs8 || layout.compression == runs4) {
    if (!readRuns(in, layout, picture)) return {};
    return picture;
  }
  const std::size_t rowBytes = (static_cast<std::size_t>(width) * layout.bits + 31) / 32 * 4;
  for (int y = 0; y < height; ++y) {
    const auto line = static_cast<std::size_t>(layout.fromTop ? y : height - 1 - y);
    readPlainRow(in, layout.pixelsAt + line * rowBytes, layout, picture, y);
  }
  // 32-bit pictures mostly leave the fourth byte 0 and mean opaque.
  bool anyAlpha = false;
  if (layout.bits > 8 && layout.mask[3] != 0)
    for (std::size_t i = 3; i < picture.rgba.size() && !anyAlpha; i += 4) anyAlpha = picture.rgba[i] != 0;
  picture.hasAlpha = anyAlpha;
  for (std::size_t i = 3; !anyAlpha && i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  return picture;
}

}  // namespace detent::importer
