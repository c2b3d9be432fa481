// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Evenly tinted areas of a plot under a curve, between two, or as a band, mostly half transparent. Lines over
// them are then traced as if on paper.

#include <functional>

#include "importer/trace/curve_colour.h"

namespace detent::importer::trace {

/// Removes such areas like a film on paper, including seams without a line. An area counts if lines with
/// clearly more contrast run along or over it; an area of a curve's full colour, a marker or a thick line is
/// left alone. Returns true if there was any. `lineDirection`: called then, direction from the paper to the
/// colour of grid and frame.
bool liftTintedAreas(Raster& raster, Color3 paper, const std::function<Color3()>& lineDirection);

}  // namespace detent::importer::trace
