// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One ink of the plot: how much of each pixel it covers. Sub-pixel lines are centroids of this coverage.

#include <cstddef>
#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// Same size as the view's raster. Grid, frame and text of the same ink are still in it.
struct InkLayer {
  int width_px = 0, height_px = 0;
  std::vector<float> coverage;  ///< 0..1, row-major
  Rgb color;                    ///< the pure ink
  Rgb paper;                    ///< the background it was measured against

  float at(int x, int y) const {
    return coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                    static_cast<std::size_t>(x)];
  }
};

}  // namespace detent::importer
