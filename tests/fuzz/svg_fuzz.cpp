// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an SVG file, up to where librsvg takes over: our own part of detent-svg-worker.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "importer/svg/drawing.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  static_cast<void>(
      detent::importer::svg::readDrawing(bytes, [](char32_t letter) { return letter < 0x3000; }));
  return 0;
}
