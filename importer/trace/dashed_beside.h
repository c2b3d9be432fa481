// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Charts of several switches with one colour each: the press solid, the release in dashes or dots. Private to
// importer/trace.

#include <optional>
#include <vector>

#include "importer/trace/curve_choice.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer::trace {

/// The path of a dashed line, and the coverage for measuring it.
struct DashedPath {
  CurveField field;
  CoarseCurve path;
};

/// Finds the dashed line in the colour of a solid curve: the remaining pixels of that colour must form a
/// dashed line over at least half of the curve's travel. `curveColours`: those of all curves.
std::optional<DashedPath> dashedBeside(const CurveTrace& solid, const CurveColour& curve,
                                       const std::vector<int>& curveColours, const PlotColours& plot);

}  // namespace detent::importer::trace
