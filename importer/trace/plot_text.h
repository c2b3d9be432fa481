// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text and legend samples inside the plot area: where not to look for curves.

#include <vector>

#include "importer/trace/ink_coverage.h"

namespace detent::importer::trace {

/// A row of letters, or a word known from elsewhere, in area pixels.
struct TextRow {
  Box box;
  std::vector<Box> letters;
};

struct PlotText {
  std::vector<TextRow> rows;
  Mask mask;  ///< 1 on letters and two pixels around them
};

/// Letters are told from curves by shape: small pieces, tall against their stroke, standing in rows. Pieces inside
/// a word already read are letters whatever their shape.
PlotText findText(const PlotArea& area, const Backdrop& backdrop);

/// A legend's sample line: a short level piece of one ink, alone, beside a text row.
struct LegendSample {
  Box box;
  int ink = 0;  ///< index into the coverage
  Box text;     ///< of the row beside it
};

/// Boxes that legends fill, from their samples and texts; drawn over curves they hide them.
std::vector<Box> legendBoxes(const std::vector<LegendSample>& samples);

std::vector<LegendSample> findLegendSamples(const Coverage& coverage, const PlotText& text,
                                            const PlotArea& area);

}  // namespace detent::importer::trace
