// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include <gif_lib.h>

#include "importer/page/stored_picture.h"

namespace detent::importer {

namespace {

/// The bytes that giflib has not read yet.
struct UnreadGif {
  std::span<const unsigned char> bytes;
};

int readSome(GifFileType* gif, GifByteType* to, int count) {
  auto& unread = *static_cast<UnreadGif*>(gif->UserData);
  const std::size_t n = std::min(unread.bytes.size(), static_cast<std::size_t>(std::max(0, count)));
  std::memcpy(to, unread.bytes.data(), n);
  unread.bytes = unread.bytes.subspan(n);
  return static_cast<int>(n);
}

struct CloseGif {
  void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};
using Gif = std::unique_ptr<GifFileType, CloseGif>;

constexpr int kOpaque = NO_TRANSPARENT_COLOR;

/// Reads an extension's blocks. Returns the index of the transparent colour from a graphics control block,
/// else `before`.
std::optional<int> transparentAfter(GifFileType* gif, int before) {
  int code = 0;
  GifByteType* block = nullptr;
  if (DGifGetExtension(gif, &code, &block) == GIF_ERROR) return {};
  GraphicsControlBlock control{};
  if (code == GRAPHICS_EXT_FUNC_CODE && block != nullptr &&
      DGifExtensionToGCB(block[0], block + 1, &control) == GIF_OK)
    before = control.TransparentColor;
  while (block != nullptr)
    if (DGifGetExtensionNext(gif, &block) == GIF_ERROR) return {};
  return before;
}

/// Rows in the order in which an interlaced picture stores them.
std::vector<int> rowsAsStored(int height, bool interlaced) {
  struct Pass {
    int from, step;
  };
  constexpr std::array<Pass, 4> passes{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
  std::vector<int> rows;
  for (const Pass& pass :
       interlaced ? std::vector<Pass>(passes.begin(), passes.end()) : std::vector<Pass>{{0, 1}})
    for (int y = pass.from; y < height; y += pass.step) rows.push_back(y);
  return rows;
}

/// Copies the current image to its place in `picture`. Returns false if it is damaged.
bool readImage(GifFileType* gif, int transparent, StoredPicture& picture) {
  const GifImageDesc& place = gif->Image;
  const ColorMapObject* const colors = place.ColorMap != nullptr ? place.ColorMap : gif->SColorMap;
  if (colors == nullptr || place.Left < 0 || place.Top < 0 || place.Width < 1 ||
      place.Left + place.Width > picture.width_px || place.Top + place.Height > picture.height_px)
    return false;
  std::vector<GifPixelType> line(static_cast<std::size_t>(place.Width));
  for (const int y : rowsAsStored(place.Height, place.Interlace)) {
    if (DGifGetLine(gif, line.data(), place.Width) == GIF_ERROR) return false;
    std::uint8_t* to = picture.row(place.Top + y) + std::ptrdiff_t{4} * place.Left;
    for (const GifPixelType pixel : line) {
      if (pixel >= colors->ColorCount) return false;
      const GifColorType& color = colors->Colors[pixel];
      to[0] = color.Red, to[1] = color.Green, to[2] = color.Blue, to[3] = pixel == transparent ? 0 : 255;
      to += 4;
    }
  }
  return true;
}

}  // namespace

std::optional<StoredPicture> decodeGif(std::span<const unsigned char> bytes, int width, int height) {
  UnreadGif unread{bytes};
  const Gif gif(DGifOpen(&unread, readSome, nullptr));
  if (!gif || gif->SWidth != width || gif->SHeight != height) return {};
  StoredPicture picture(width, height);
  // Pixels outside the image stay transparent.
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 0;
  picture.hasAlpha = true;
  int transparent = kOpaque, images = 0;
  for (GifRecordType record = UNDEFINED_RECORD_TYPE; record != TERMINATE_RECORD_TYPE;) {
    if (DGifGetRecordType(gif.get(), &record) == GIF_ERROR) return {};
    if (record == EXTENSION_RECORD_TYPE) {
      const auto after = transparentAfter(gif.get(), transparent);
      if (!after) return {};
      transparent = *after;
    } else if (record == IMAGE_DESC_RECORD_TYPE) {
      // An animation may show a growing graph, and which of its images is complete is unknown.
      if (++images > 1 || DGifGetImageDesc(gif.get()) == GIF_ERROR) return {};
      if (!readImage(gif.get(), transparent, picture)) return {};
    }
  }
  if (images == 0) return {};
  return picture;
}

}  // namespace detent::importer
