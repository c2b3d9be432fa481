// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How much of each pixel each ink covers: the pixel is explained by the backdrop and as few inks as possible
// (one; two where lines cross or touch).

#include <vector>

#include "importer/trace/ink_palette.h"

namespace detent::importer::trace {

struct Coverage {
  std::vector<Plane> ink;  ///< one per ink of the palette, 0..1.2
  Plane unknown;           ///< covered by something no ink explains
};

/// Pixels of the largest coverage in blocks of `factor`²: enough to see where curves run.
Plane pooled(const Plane& plane, int factor);

Coverage unmix(const PlotScene& scene, const std::vector<Ink>& inks);

}  // namespace detent::importer::trace
