// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text inside the plot area, where no curves are searched.

#include <vector>

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

struct Lettering {
  std::vector<Box> rows;  ///< of letters, and words known earlier; area px
  Mask mask;              ///< 1 on letters and two pixels around them
};

/// Recognises letters by shape: small pieces, tall relative to their stroke, in rows. Pieces inside a known
/// word are always letters. `contrasts`: colour difference to the background, 0..255, per pixel.
Lettering findLettering(const PlotArea& area, const Mask& contrasts, float coverageThreshold);

}  // namespace detent::importer::trace
