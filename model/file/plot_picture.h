// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A plot as pixels for programs that read no SVG: frame, grid, tick labels and both strokes.

#include <string>

#include "model/file/svg_plot.h"

namespace detent {

/// PNG of style.width_px by style.height_px (rounded) pixels, laid out as in frameOfPlot(), without titles
/// and callouts. Deterministic; about 10 ms for 640 x 460. Any thread.
std::string pngFrom(const ButtonState& state, const SvgPlotStyle& style = {});

}  // namespace detent
