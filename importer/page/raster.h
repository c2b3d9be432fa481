// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Plain pixels and plain geometry; what the importer's steps hand each other (no third-party type in a
// header).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace detent::importer {

/// A position. Which plane it is in (page units or view pixels) is said by the name that holds it.
struct Point {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Axis-parallel box, y down. Empty if x1 <= x0 or y1 <= y0.
struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  bool empty() const { return x1 <= x0 || y1 <= y0; }
  bool contains(Point p) const { return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1; }
  friend bool operator==(const Box&, const Box&) = default;
};

/// 8-bit sRGB, opaque, rows without padding, top row first. Pixel (0,0)'s centre is the point (0,0).
struct Raster {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3

  bool empty() const { return width_px <= 0 || height_px <= 0; }
  const std::uint8_t* at(int x, int y) const {
    return rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                             static_cast<std::size_t>(x));
  }
};

/// p' = (a·x + c·y + e, b·x + d·y + f), as in PDF and SVG.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// The map that first applies `first`, then this.
  Affine after(const Affine& first) const;
  /// Determinant must not be 0 (checked).
  Affine inverse() const;
  friend bool operator==(const Affine&, const Affine&) = default;
};

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

}  // namespace detent::importer
