// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The colours in front of the background. An antialiased, thin or pale line shows its colour only mixed with
// the background, so colours are separated by the *direction* of their difference, which mixing does not
// change; its length is the strength.

#include <vector>

#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

struct PaletteLimits {
  int maxColours = 8;
  double minMass_px = 12;     ///< fainter colours are dust
  double mergeAngle_deg = 9;  ///< closer directions are one colour
};

/// Colours by number of pixels, largest first; pixels set in `excluded` are ignored. Blends of two larger
/// colours are left out.
std::vector<PaletteColour> findColours(const PlotScene& scene, const Mask& excluded,
                                       const PaletteLimits& limits = {});

/// Adds the colour of most letters, unless it is in the palette; otherwise their pixels would count as the
/// nearest curve's.
void addLetterColour(std::vector<PaletteColour>& colours, const PlotScene& scene);

}  // namespace detent::importer::trace
