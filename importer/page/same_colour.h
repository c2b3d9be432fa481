// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Distance of colours, and whether a pixel has a curve's colour. Any thread.

#include <cmath>

#include "importer/page/raster.h"

namespace detent::importer {

/// Colour levels.
inline double colorDistance(Rgb a, Rgb b) { return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b); }

/// Returns true if two colours are about the same.
inline bool isSameColour(Rgb a, Rgb b) {
  constexpr double sameColour = 70;  // colour levels
  return colorDistance(a, b) <= sameColour;
}

/// Returns true if the pixel has about this colour; false outside the picture.
inline bool hasColour(const Raster& picture, Rgb color, int x, int y) {
  if (x < 0 || y < 0 || x >= picture.width_px || y >= picture.height_px) return false;
  const std::uint8_t* p = picture.at(x, y);
  return isSameColour({p[0], p[1], p[2]}, color);
}

}  // namespace detent::importer
