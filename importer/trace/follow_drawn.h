// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Beside tracing: a curve that a person drew along its ink, where the tracer did not find it.

#include <vector>

#include "importer/page/page.h"

namespace detent::importer {

/// How a drawn line is followed. Plain value.
struct DrawnOptions {
  double reach_px = 8;    ///< how far from the line ink is looked for; (0, 64]
  double spacing_px = 1;  ///< of the points that come out; (0, 16]
};

/// Points along a smooth line through the drawn ones, each pulled to the middle of the ink near it. The pull is
/// one course over the whole line, not point for point: where the ink has a gap or is crossed by a gridline
/// the line goes on as it was; without any ink it stays as drawn. Fewer than two different points give nothing.
/// View pixels; any thread.
std::vector<Point> followDrawn(const Raster& raster, const std::vector<Point>& drawn_px,
                               const DrawnOptions& options = {});

}  // namespace detent::importer
