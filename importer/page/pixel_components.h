// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Connected components of a mask, found by runs of pixels. Drawings are nearly all paper, which costs almost
// no time this way.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// A connected component: marked pixels that touch at edges or corners.
struct PixelComponent {
  Box box;  ///< box of whole pixels: x1 and y1 are the first column and row beyond it
  int area_px = 0;
  int runsAcross = 0;  ///< number of runs of marked pixels in all its rows
  int runsDown = 0;    ///< number of runs of marked pixels in all its columns
};

/// Marked pixels of one row without a gap.
struct PixelRun {
  int y = 0, from = 0, to = 0;  ///< to: the first column beyond it
  std::size_t piece = 0;        ///< index of the piece it belongs to
};

struct PixelComponents {
  std::vector<PixelComponent> all;  ///< in the order in which their first pixels come, two rows at a time
  std::vector<PixelRun> runs;       ///< row by row, from the left
};

/// The connected components of the non-zero pixels in `height` rows of `width` bytes, `stride` bytes apart.
PixelComponents pixelComponentsOf(const std::uint8_t* mask, int width, int height, std::size_t stride);

}  // namespace detent::importer
