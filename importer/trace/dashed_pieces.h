// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines of dashes and dots of which the document draws each one by itself, made the lines that they are.
// Private to importer/trace.

#include <cstddef>
#include <optional>
#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// A short piece of one ink: perhaps one of a line's dashes.
struct DashPiece {
  std::vector<Point> points;  ///< along its middle; a dot is a single one
  double width_px = 1;
};

/// Dashes one behind the other, at even gaps and however steeply the line bends between them.
struct DashedLine {
  std::vector<Point> points;
  double width_px = 1;
  std::vector<std::size_t> members;  ///< of the pieces given
};

/// A dash or dot that a drawing program has turned into a filled outline, however its bends made the outline cross itself;
/// nothing if it is longer than `largest_px` or no such shape.
std::optional<DashPiece> dashOfOutline(const std::vector<Point>& outline, double largest_px);

/// Every line of eight and more of the pieces, which are all of one ink. Nothing where they are thousands.
std::vector<DashedLine> dashedLines(const std::vector<DashPiece>& pieces);

}  // namespace detent::importer
