// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The second opinion on a frame: its numbers count on beyond an edge where the edge is an inner gridline.

#include <optional>

#include "importer/axes/axis_calibration.h"

namespace detent::importer {

/// The frame widened to the outermost words that stand where the labels' progression goes on, in view pixels;
/// nullopt where none does, as on nearly all pages. Upright frames. Nothing is read: whoever reads the wider
/// frame's axes sees whether the words are numbers that count on.
std::optional<Box> frameByNumbers(const PageView& view, const PlotFrame& frame, const AxisCalibration& axes);

}  // namespace detent::importer
