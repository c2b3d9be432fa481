// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text inside the plot area: where not to look for curves.

#include <vector>

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

struct Lettering {
  std::vector<Box> rows;  ///< of letters, and words known from elsewhere; area px
  Mask mask;              ///< 1 on letters and two pixels around them
};

/// Letters are told from curves by shape: small pieces, tall against their stroke, standing in rows. Pieces inside
/// a word already read are letters whatever their shape. `contrasts`: colour difference to what lies behind, 0..255, per pixel.
Lettering findLettering(const PlotArea& area, const Mask& contrasts, float inkThreshold);

}  // namespace detent::importer::trace
