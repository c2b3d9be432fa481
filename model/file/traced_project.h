// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A graph as a project of WebPlotDigitizer, for people who go on by hand there. Its other way in: importer/log/digitizer_project.

#include <string>

#include "model/file/svg_plot.h"

namespace detent {

/// Version 4.2, as JSON: axes "mm, N" (or the style's units) calibrated on the frame of the state's plot, data sets "press" and
/// "release" of travelledSamples. Places are those of `svgFrom` of a button with this one state, so that the plot is the picture to
/// load beside it; values stand in the file too. Any thread.
std::string tracedProjectFrom(const ButtonState& state, const SvgPlotStyle& style = {});

/// The same with its picture (a PNG), as the TAR archive that WebPlotDigitizer saves: one file that opens there as it stands. The same
/// bytes at any time.
std::string tracedArchiveFrom(const ButtonState& state, const SvgPlotStyle& style = {});

}  // namespace detent
