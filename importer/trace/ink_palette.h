// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which inks stand in front of the backdrop. An anti-aliased, thin or pale line shows its ink only mixed with
// what lies behind, so inks are told by the *direction* of the colour difference, which mixing does not
// change; how far they go is the strength.

#include <vector>

#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

struct PaletteLimits {
  int maxInks = 8;
  double minMass_px = 12;     ///< fainter inks are dust
  double mergeAngle_deg = 9;  ///< directions closer than this are one ink
};

/// Inks by mass, heaviest first; pixels set in `excluded` have no say. Blends of two heavier inks are left
/// out.
std::vector<Ink> findInks(const PlotScene& scene, const Mask& excluded, const PaletteLimits& limits = {});

/// Adds the ink most letters have, unless it is in the palette. Without it their pixels would be taken for the nearest
/// curve's.
void addLetterInk(std::vector<Ink>& inks, const PlotScene& scene);

}  // namespace detent::importer::trace
