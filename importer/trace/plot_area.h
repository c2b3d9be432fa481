// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The part of the view in which curves are drawn, upright: rows run along the displacement axis, columns
// along the force axis. An axis-parallel frame is cropped (and, if huge, shrunk by a whole factor); any other
// is warped. Everything about differently coloured curves happens on it; `toView` brings results back to the
// view's pixels.

#include <array>
#include <cstdint>
#include <vector>

#include "importer/frame/plot_frame.h"

namespace detent::importer::inks {

/// Row-major values, one per pixel of a plot area.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  Plane() = default;
  Plane(int w, int h, float value = 0)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  float& at(int x, int y) { return values[index(x, y)]; }
  float at(int x, int y) const { return values[index(x, y)]; }
  /// Bilinear; 0 outside.
  float sample(double x, double y) const;
};

/// Pixels of the plot area with a margin of `marginPx` around the frame.
struct PlotArea {
  static constexpr int marginPx = 4;

  Raster raster;
  Box frame;                        ///< the frame's edges in area pixels
  std::array<double, 9> toViewMap;  ///< homography, area px -> view px, row-major

  Point toView(Point area_px) const;
  Point fromView(Point view_px) const;
};

/// Empty raster if the frame lies outside the view or has no area.
PlotArea makePlotArea(const Raster& view, const PlotFrame& frame);

}  // namespace detent::importer::inks
