// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds labels along a rectangle's axes by the places of marks, without reading them.

#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// Words aligned with an axis of an upright rectangle.
struct LabelRow {
  std::vector<Box> words;  ///< in order along the axis
  double height_px = 0;    ///< height of a typical word
  int regular = 0;         ///< number of words at even distances or at gridlines
};

/// Row of labels below the rectangle. `lines`: x of its vertical lines (may be empty).
LabelRow labelsBelow(const std::vector<Box>& words, const Box& rectangle, const std::vector<double>& lines);

/// Row of labels above the rectangle.
LabelRow labelsAbove(std::vector<Box> words, const Box& rectangle, const std::vector<double>& lines);

/// Column of labels left of the rectangle. `lines`: y of its horizontal lines.
LabelRow labelsLeft(const std::vector<Box>& words, const Box& rectangle, const std::vector<double>& lines);

/// Column of labels right of the rectangle.
LabelRow labelsRight(std::vector<Box> words, const Box& rectangle, const std::vector<double>& lines);

/// Rotated labels on the left, whose digits stand one above the other.
LabelRow labelsUpwards(const std::vector<Box>& words, const Box& rectangle, const std::vector<double>& lines);

}  // namespace detent::importer
