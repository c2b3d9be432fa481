// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Follows a curve that a person drew where the tracer did not find it.

#include <vector>

#include "importer/page/page.h"

namespace detent::importer {

/// Returns points about a pixel apart along the curve that runs by the drawn ones: between two of them the way
/// with the most of the curve's colour for its length (Mortensen, Barrett, "Intelligent scissors for image
/// composition", 1995), then the middle of the curve. Gaps are bridged; where there is no curve, the points
/// lie on a smooth line through the drawn ones. Fewer than two different points give an empty result.
/// `reach_px`: distance up to which a drawn point may lie beside the curve; (0, 64]. View pixels; any thread.
std::vector<Point> followDrawn(const Raster& raster, const std::vector<Point>& drawn_px, double reach_px = 8);

}  // namespace detent::importer
