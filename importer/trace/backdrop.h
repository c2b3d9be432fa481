// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What lies behind the curves: paper and the lines that cross the whole frame (grid, frame). Known per row
// and column, so that subtracting it removes the grid without touching a curve that runs over it.

#include <cmath>
#include <vector>

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

/// A colour or a difference of colours, 8-bit sRGB scale.
struct Color3 {
  float r = 0, g = 0, b = 0;

  friend Color3 operator+(Color3 p, Color3 q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
  friend Color3 operator-(Color3 p, Color3 q) { return {p.r - q.r, p.g - q.g, p.b - q.b}; }
  friend Color3 operator*(float s, Color3 p) { return {s * p.r, s * p.g, s * p.b}; }
  friend float dot(Color3 p, Color3 q) { return p.r * q.r + p.g * q.g + p.b * q.b; }
  friend float norm(Color3 p) { return std::sqrt(dot(p, p)); }
};

inline Color3 colorAt(const Raster& raster, int x, int y) {
  const std::uint8_t* p = raster.at(x, y);
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

/// The area's commonest colour.
Color3 paperOf(const PlotArea& area);

Rgb rgbOf(Color3 color);

class Backdrop {
 public:
  /// Lines are taken from the picture itself: a row or column most of whose pixels differ from the paper.
  /// The area's known lines say where such a line may be a lone one.
  static Backdrop measure(const PlotArea& area);

  Color3 paper() const { return paper_; }
  Color3 paperAt(int x, int y) const { return shading_.empty() ? paper_ : shadedPaper(x, y); }
  /// Paper, or the gridline there.
  Color3 at(int x, int y) const {
    const Line &row = rows_[static_cast<std::size_t>(y)], &column = columns_[static_cast<std::size_t>(x)];
    return paperAt(x, y) + (row.square >= column.square ? row.difference : column.difference);
  }
  bool onLine(int x, int y) const {
    return rows_[static_cast<std::size_t>(y)].square > 0 || columns_[static_cast<std::size_t>(x)].square > 0;
  }
  /// Unit vector from the paper to the colour of grid and frame; zero where there are none.
  Color3 lineDirection() const { return lineDirection_; }
  /// Colour differences below this are noise (camera, JPEG); 0 for a clean render.
  float noise() const { return noise_; }

 private:
  Color3 shadedPaper(int x, int y) const;
  void measureShading(const PlotArea& area);
  void measureLines(const PlotArea& area);
  void measureNoise(const PlotArea& area);

  Color3 paper_;
  Color3 lineDirection_;
  float noise_ = 0;
  /// Difference to the paper of a line along a row or column, and its square; 0 where none runs.
  struct Line {
    Color3 difference;
    float square = 0;
  };
  std::vector<Line> rows_, columns_;
  int tilesAcross_ = 0, tilesDown_ = 0;
  double tileWidth_ = 1, tileHeight_ = 1;
  std::vector<Color3> shading_;  ///< paper per tile; empty for an even paper
};

}  // namespace detent::importer::trace
