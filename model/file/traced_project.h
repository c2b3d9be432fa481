// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A graph as a WebPlotDigitizer project. Reading: importer/log/digitizer_project.

#include <string>

#include "model/file/svg_plot.h"

namespace detent {

/// Version 4.2 as JSON: axes "mm, N" (or the style's units) calibrated on the frame of the state's plot, data
/// sets "press" and "release" of travelledSamples. Positions match `svgFrom` of a button with this one state,
/// so that its plot is the picture to load; values are included. Any thread.
std::string tracedProjectFrom(const ButtonState& state, const SvgPlotStyle& style = {});

/// The project with its picture (PNG) as the TAR archive that WebPlotDigitizer saves and opens.
/// Deterministic.
std::string tracedArchiveFrom(const ButtonState& state, const SvgPlotStyle& style = {});

}  // namespace detent
