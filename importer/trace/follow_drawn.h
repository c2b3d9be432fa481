// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Follows a curve that a person drew where the tracer did not find it.

#include <vector>

#include "importer/page/page.h"

namespace detent::importer {

/// Options for following a drawn line. Plain value.
struct DrawnOptions {
  double reach_px = 8;    ///< search distance from the line; (0, 64]
  double spacing_px = 1;  ///< spacing of the resulting points; (0, 16]
};

/// Returns points along a smooth line through the drawn ones, each pulled to the middle of the curve near it.
/// The pull is one path for the whole line: across gaps and gridlines the line continues, and without any
/// curve it stays as drawn. Fewer than two different points give an empty result. View pixels; any thread.
std::vector<Point> followDrawn(const Raster& raster, const std::vector<Point>& drawn_px,
                               const DrawnOptions& options = {});

}  // namespace detent::importer
