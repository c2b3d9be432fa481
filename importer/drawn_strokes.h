// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines drawn by hand along the curves, in place of a traced stroke or of a part of it.

#include <vector>

#include "importer/importer.h"

namespace detent::importer {

/// A drawn line that covers less than this share of a traced stroke's displacement replaces that part alone.
inline constexpr double wholeStrokeShare = 0.8;

/// A drawn line (page units) as a stroke: followed along the curve's pixels, in mm and N, in the order
/// travelled. Empty if it is no line.
StrokePoints strokeFromDrawn(const std::vector<Point>& drawn, Stroke stroke, const PageView& view,
                             const PlotFrame& frame, const AxisCalibration& calibration);

/// `traced` with `drawn` in place of all of it, or of the part that `drawn` covers. Both in the order
/// travelled.
StrokePoints withDrawnPart(const StrokePoints& traced, const StrokePoints& drawn);

}  // namespace detent::importer
