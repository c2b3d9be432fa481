// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Joins dashes and dots that a document draws one by one. Private to importer/trace.

#include <cstddef>
#include <optional>
#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// A short piece of one colour that may be a dash.
struct DashPiece {
  std::vector<Point> points;  ///< along its middle; one point for a dot
  double width_px = 1;
};

/// Dashes at even gaps, however sharply the line bends.
struct DashedLine {
  std::vector<Point> points;
  double width_px = 1;
  std::vector<std::size_t> members;  ///< of the pieces given
};

/// Returns the dash or dot of a filled outline, even if its bends made the outline cross itself; nullopt if
/// it is longer than `largest_px` or has another shape.
std::optional<DashPiece> dashOfOutline(const std::vector<Point>& outline, double largest_px);

/// Returns every line of eight or more of these pieces, which have one colour. Empty for thousands of pieces.
std::vector<DashedLine> dashedLines(const std::vector<DashPiece>& pieces);

}  // namespace detent::importer
