// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Coverage of each pixel by each colour: a pixel is the background and as few colours as possible (one; two
// where lines cross or touch).

#include <vector>

#include "importer/trace/colour_palette.h"

namespace detent::importer::trace {

struct Coverage {
  std::vector<Plane> planes;  ///< one per colour of the palette, 0..1.2
  Plane unknown;              ///< covered by something that no colour explains
};

/// Maxima in blocks of `factor`² pixels, sufficient for the path search.
Plane pooled(const Plane& plane, int factor);

Coverage unmix(const PlotScene& scene, const std::vector<PaletteColour>& colours);

}  // namespace detent::importer::trace
