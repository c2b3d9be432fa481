// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Plain pixels and geometry that the importer's steps exchange. No third-party type appears in a header.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace detent::importer {

/// A position. The name of the variable states its plane (page units or view pixels).
struct Point {
  double x = 0, y = 0;
  friend bool operator==(const Point&, const Point&) = default;
  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(double s, Point p) { return {s * p.x, s * p.y}; }
  friend double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
  friend double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
  friend double norm(Point p) { return std::hypot(p.x, p.y); }
  friend double distance(Point a, Point b) { return norm(a - b); }
};

/// Axis-parallel box, y down. Empty if x1 <= x0 or y1 <= y0.
struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  bool empty() const { return x1 <= x0 || y1 <= y0; }
  double area() const { return width() * height(); }
  Point middle() const { return {0.5 * (x0 + x1), 0.5 * (y0 + y1)}; }
  bool contains(Point p) const { return p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1; }
  bool contains(const Box& b) const { return b.x0 >= x0 && b.y0 >= y0 && b.x1 <= x1 && b.y1 <= y1; }
  /// Returns true if the boxes share a point, even if only on their edges.
  bool touches(const Box& b) const { return x1 >= b.x0 && x0 <= b.x1 && y1 >= b.y0 && y0 <= b.y1; }
  Box grown(double dx, double dy) const { return {x0 - dx, y0 - dy, x1 + dx, y1 + dy}; }
  /// The smallest box around both.
  Box joined(const Box& b) const {
    return {std::min(x0, b.x0), std::min(y0, b.y0), std::max(x1, b.x1), std::max(y1, b.y1)};
  }
  /// The intersection; empty if the boxes do not meet.
  Box common(const Box& b) const {
    return {std::max(x0, b.x0), std::max(y0, b.y0), std::min(x1, b.x1), std::min(y1, b.y1)};
  }
  /// Returns true if the boxes stand in one column or row, as texts of a legend do: within the height of the
  /// lower one.
  bool inLineWith(const Box& b) const {
    const double within = std::min(height(), b.height());
    return std::abs(x0 - b.x0) < within || std::abs(x1 - b.x1) < within ||
           std::abs(middle().y - b.middle().y) < 0.5 * within;
  }
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

struct Homography;

/// p' = (a·x + c·y + e, b·x + d·y + f), as in PDF and SVG.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// The map that first applies `first`, then this.
  Affine after(const Affine& first) const;
  /// Determinant must not be 0 (checked).
  Affine inverse() const;
  /// The upright box around a box under this map.
  Box boxOf(const Box& box) const;
  operator Homography() const;
  friend bool operator==(const Affine&, const Affine&) = default;
};

/// A projective map, row-major: p' = ((m0 x + m1 y + m2) / w, (m3 x + m4 y + m5) / w), w = m6 x + m7 y + m8.
struct Homography {
  std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Point operator()(Point p) const {
    const double w = m[6] * p.x + m[7] * p.y + m[8];
    return {(m[0] * p.x + m[1] * p.y + m[2]) / w, (m[3] * p.x + m[4] * p.y + m[5]) / w};
  }
  /// The map that first applies `first`, then this.
  Homography after(const Homography& first) const;
  /// Must be invertible (checked).
  Homography inverse() const;
  /// The upright box around a box under this map.
  Box boxOf(const Box& box) const;
  bool isAffine() const { return m[6] == 0 && m[7] == 0; }
  /// Local scale factor at `p`, mean of all directions.
  double scaleAt(Point p) const;
  friend bool operator==(const Homography&, const Homography&) = default;
};

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

}  // namespace detent::importer
