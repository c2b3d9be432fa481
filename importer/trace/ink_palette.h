// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which inks stand in front of the backdrop. An anti-aliased, thin or pale line shows its ink only mixed with
// what lies behind, so inks are told by the *direction* of the colour difference, which mixing does not
// change; how far they go is the strength.

#include <vector>

#include "importer/trace/backdrop.h"

namespace detent::importer::trace {

struct Ink {
  Color3 direction;      ///< unit vector, ink minus paper
  float strength = 0;    ///< distance of the full ink from the paper, colour levels
  double mass_px = 0;    ///< pixels of full coverage
  bool isCurve = false;  ///< draws a curve: where several mixtures explain a pixel, one of curves is likelier

  Color3 difference() const { return strength * direction; }
};

struct PaletteLimits {
  int maxInks = 8;
  double minMass_px = 12;     ///< fainter inks are dust
  double mergeAngle_deg = 9;  ///< directions closer than this are one ink
};

/// Smallest colour difference that is ink, not noise.
float inkThreshold(const Backdrop& backdrop);

/// Inks by mass, heaviest first; pixels set in `excluded` have no say. Blends of two heavier inks are left
/// out.
std::vector<Ink> findInks(const PlotArea& area, const Backdrop& backdrop, const Mask& excluded,
                          const PaletteLimits& limits = {});

/// Adds the ink most letters have, unless it is in the palette: `letters` marks them. Without it their pixels
/// would be taken for the nearest curve's.
void addLetterInk(std::vector<Ink>& inks, const PlotArea& area, const Backdrop& backdrop,
                  const Mask& letters);

/// Given inks (hints) measured on the area: direction from the colour itself.
Ink inkOfColor(Rgb color, const Backdrop& backdrop);

}  // namespace detent::importer::trace
