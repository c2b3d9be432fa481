// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Evenly tinted areas of a plot: what programs paint under a curve, between two or as a band, mostly half transparent. Lines over
// them are looked for as if they stood on the paper.

#include <functional>

#include "importer/trace/curve_ink.h"

namespace detent::importer::trace {

/// Takes such areas off the picture as a film is taken off paper, seams without a line included. One counts where lines with clearly
/// more contrast run along or over it: a ground of a curve's full ink, a marker or a thick line is left alone. Whether there was any. `lineDirection`: asked for
/// then, from the paper to the colour of grid and frame.
bool liftTintedAreas(Raster& raster, Color3 paper, const std::function<Color3()>& lineDirection);

}  // namespace detent::importer::trace
