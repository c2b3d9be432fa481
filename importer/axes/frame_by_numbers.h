// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Checks a plot frame by its numbers: if they continue beyond an edge, that edge is an inner gridline.

#include <optional>

#include "importer/axes/axis_calibration.h"

namespace detent::importer {

/// The frame widened to the outermost words whose positions continue the progression of the labels, in view
/// pixels; nullopt if there are none, as on nearly all pages. Upright frames only. The words are not read
/// here: reading the axes of the wider frame shows whether they continue the numbers.
std::optional<Box> frameByNumbers(const PageView& view, const PlotFrame& frame, const AxisCalibration& axes);

}  // namespace detent::importer
