// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The work plane of the loop tracer: the plot frame made upright and rectangular, at a scale where the global
// search is cheap. In: the ink layer and the frame's corners. Out: ink on the plane, and the map back to view
// pixels.

#include <array>
#include <vector>

#include "importer/frame/plot_frame.h"
#include "importer/trace/ink_layer.h"

namespace detent::importer::loop {

/// Row-major values, one per pixel of some raster.
struct Grid {
  int width = 0, height = 0;
  std::vector<float> values;

  Grid() = default;
  Grid(int w, int h, float value = 0)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  float& at(int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  float at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Bilinear value; outside the raster the nearest edge counts.
double sampleAt(const Grid& grid, Point p);
double sampleAt(const InkLayer& ink, Point p);

struct Plane {
  Grid ink;                        ///< coverage 0..1; paper outside the page
  std::array<double, 9> toView{};  ///< homography, plane px -> view px, row-major
  std::array<double, 9> fromView{};
  Box frame;         ///< the frame's edges in plane px
  double scale = 1;  ///< view pixels per plane pixel at the frame's centre

  Point view(Point plane_px) const;
  Point plane(Point view_px) const;
};

struct PlaneOptions {
  int maxWidth_px = 520;  ///< of the frame on the plane; [64, 4096]
  double margin_px = 4;   ///< kept around the frame, plane px
};

/// An axis-parallel frame is shrunk by a whole factor and never resampled; any other is warped.
Plane makePlane(const InkLayer& ink, const PlotFrame& frame, const PlaneOptions& options);

}  // namespace detent::importer::loop
