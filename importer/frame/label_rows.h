// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Do numbers stand along a rectangle as they stand along axes? Judged from where ink is, nothing is read.

#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// Words that line up with an axis of an upright rectangle.
struct LabelRow {
  std::vector<Box> words;  ///< in order along the axis
  double height_px = 0;    ///< of a typical word
  int regular = 0;         ///< how many of them stand at evenly spaced places or at gridlines
};

/// The row of labels below the rectangle. `lines` are the x of its vertical lines (may be empty).
LabelRow labelsBelow(const std::vector<Box>& words, const Box& rectangle, const std::vector<double>& lines);

/// The row above it.
LabelRow labelsAbove(std::vector<Box> words, const Box& rectangle, const std::vector<double>& lines);

/// The column of labels left of the rectangle. `lines` are the y of its horizontal lines.
LabelRow labelsLeft(const std::vector<Box>& words, const Box& rectangle, const std::vector<double>& lines);

/// The column right of it.
LabelRow labelsRight(std::vector<Box> words, const Box& rectangle, const std::vector<double>& lines);

/// Numbers on the left that read upwards, as some programs set them: their digits stand one above the other.
LabelRow labelsUpwards(const std::vector<Box>& words, const Box& rectangle, const std::vector<double>& lines);

}  // namespace detent::importer
