// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines drawn by hand along the curves, in place of a traced stroke or of a part of it.

#include <vector>

#include "importer/importer.h"

namespace detent::importer {

/// A drawn line (page units) as a stroke: followed along the curve's pixels, in mm and N, in the order
/// travelled. Empty if it is no line.
StrokePoints strokeFromDrawn(const std::vector<Point>& drawn, Stroke stroke, const PageView& view,
                             const PlotFrame& frame, const AxisCalibration& calibration);

/// Returns true if a drawn stroke replaces all of a traced one. Both have points.
bool drawsWhole(const StrokePoints& traced, const StrokePoints& drawn);

/// `traced` with `drawn` in place of all of it, or of the part that `drawn` covers. Both in the order
/// travelled.
StrokePoints withDrawnPart(const StrokePoints& traced, const StrokePoints& drawn);

}  // namespace detent::importer
