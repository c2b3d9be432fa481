// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The part of the view in which curves are drawn, upright: rows run along the displacement axis, columns
// along the force axis. An axis-parallel frame is cropped (and reduced by a whole factor if huge); any other
// is warped. All pixel tracing works on it, with the known positions of lines and words and the user's masks;
// `toView` maps results back to the view.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "importer/axes/axis_calibration.h"

namespace cv {
class Mat;
}

namespace detent::importer::trace {

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
  float sample(Point p) const { return sample(p.x, p.y); }
};

/// Shares the memory, which must outlive the result and may be written through it.
cv::Mat matOf(const Plane& plane);

/// One byte per pixel of the area; the holder defines the bits.
using Mask = std::vector<std::uint8_t>;

/// Pixels of the plot area with a margin of `marginPx` around the frame.
struct PlotArea {
  static constexpr int marginPx = 4;

  Raster raster;
  Box frame;                                ///< the frame's edges in area pixels
  Homography toView, fromView;              ///< area px -> view px and back
  std::vector<double> columns_px, rows_px;  ///< the frame's edges and the gridlines known, area px
  std::vector<Box> words;                   ///< texts read earlier that overlap the frame, area px
  Mask masked;                              ///< 1 where nothing is to be searched; empty if there is no mask

  std::size_t pixels() const {
    return static_cast<std::size_t>(raster.width_px) * static_cast<std::size_t>(raster.height_px);
  }
};

/// Returns true if a position is close to one of the plot's lines.
inline bool isAtOneOf(const std::vector<double>& lines, double position, double within) {
  return std::ranges::any_of(lines, [&](double line) { return std::abs(line - position) <= within; });
}

/// Empty raster if the frame lies outside the view or has no area. `masks_px`: view pixels.
PlotArea makePlotArea(const Raster& view, const PlotFrame& frame, const std::vector<SeenText>& texts = {},
                      const std::vector<Box>& masks_px = {});

}  // namespace detent::importer::trace
