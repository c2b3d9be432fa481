// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Whether a pixel is of a curve's ink. Any thread.

#include <cmath>

#include "importer/page/raster.h"

namespace detent::importer {

/// Whether a pixel, inside the picture or not, has about this colour.
inline bool isInkOf(const Raster& picture, Rgb color, int x, int y) {
  constexpr double sameInk = 70;  // colour levels
  if (x < 0 || y < 0 || x >= picture.width_px || y >= picture.height_px) return false;
  const std::uint8_t* p = picture.at(x, y);
  return std::hypot(p[0] - color.r, p[1] - color.g, p[2] - color.b) <= sameInk;
}

}  // namespace detent::importer
