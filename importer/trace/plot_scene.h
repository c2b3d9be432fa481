// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The plot as every tracer sees it, made once from view, plot frame and words: upright pixels, paper, lines
// across the whole frame (grid, edges), letters, and the coverage by a curve's colour. Lines are known per
// row and column, so that subtracting them removes the grid without touching a curve on it.

#include <algorithm>
#include <list>
#include <optional>
#include <utility>
#include <vector>

#include "importer/trace/curve_colour.h"
#include "importer/trace/plot_text.h"

namespace detent::importer::trace {

/// Keeps nothing of the view. What not every plot needs is computed on first use, so it is for one thread.
class PlotScene {
 public:
  /// Empty if the frame lies outside the view or has no area. `masks_px`: ignored regions, view pixels.
  PlotScene(const Raster& view, const PlotFrame& frame, const std::vector<SeenText>& words = {},
            const std::vector<Box>& masks_px = {});

  bool empty() const { return area_.raster.empty(); }
  const PlotFrame& plotFrame() const { return frame_; }  ///< in view pixels
  const PlotArea& area() const { return area_; }
  Color3 pixel(int x, int y) const { return colorAt(area_.raster, x, y); }

  /// The area's most frequent colour.
  Color3 paper() const { return paper_; }
  Color3 paperAt(int x, int y) const { return shading_.empty() ? paper_ : shadedPaper(x, y); }
  /// Paper, or the gridline there.
  Color3 behind(int x, int y) const {
    const Line &row = rows_[static_cast<std::size_t>(y)], &column = columns_[static_cast<std::size_t>(x)];
    return paperAt(x, y) + (row.square >= column.square ? row.difference : column.difference);
  }
  bool onLine(int x, int y) const {
    return rows_[static_cast<std::size_t>(y)].square > 0 || columns_[static_cast<std::size_t>(x)].square > 0;
  }
  /// Unit vector from the paper to the colour of grid and frame; zero without lines.
  Color3 lineDirection() const { return lineDirection_; }
  /// Colour differences below this are noise (camera, JPEG); 0 for a clean rendering.
  float noise() const { return noise_; }
  /// Smallest colour difference above noise.
  float coverageThreshold() const { return std::max(10.0F, 4.5F * noise_); }

  const Lettering& lettering() const;
  /// Coverage by a curve's colour.
  const ColourOnArea& coverageOf(Rgb color) const;

 private:
  Color3 shadedPaper(int x, int y) const;
  void measureShading();
  void measureLines();
  void measureNoise();

  PlotFrame frame_;
  PlotArea area_;
  Color3 paper_;
  Color3 lineDirection_;
  float noise_ = 0;
  /// Difference of a line along a row or column to the paper, and its square; 0 without a line.
  struct Line {
    Color3 difference;
    float square = 0;
  };
  std::vector<Line> rows_, columns_;
  int tilesAcross_ = 0, tilesDown_ = 0;
  double tileWidth_ = 1, tileHeight_ = 1;
  std::vector<Color3> shading_;  ///< paper per tile; empty for an even paper
  mutable std::optional<Lettering> lettering_;
  mutable std::list<std::pair<Rgb, ColourOnArea>> coloursOnArea_;
};

}  // namespace detent::importer::trace
