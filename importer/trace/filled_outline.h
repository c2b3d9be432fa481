// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines that a drawing program has converted to filled outlines. Private to importer/trace.

#include <optional>
#include <vector>

#include "importer/page/polyline.h"

namespace detent::importer {

struct OutlineCentre {
  std::vector<Point> points;
  double width_px = 0;
};

/// Centre line of a long thin filled shape; nullopt for other shapes (letters, boxes, arrow heads, areas).
/// `maxWidth_px`: wider shapes are no lines.
std::optional<OutlineCentre> centreOfOutline(const std::vector<Point>& outline, double maxWidth_px);

}  // namespace detent::importer
