// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Charts of several switches give each one colour, draw its press through and its release in dashes or dots. Private to
// importer/trace.

#include <optional>
#include <vector>

#include "importer/trace/curve_choice.h"
#include "importer/trace/curve_trace.h"

namespace detent::importer::trace {

/// A course drawn in dashes, and the ink that is left to measure it on.
struct DashedCourse {
  CurveField field;
  CoarseCurve course;
};

/// The line of dashes in the ink of a curve that is drawn through, if what that leaves over of its ink is one, over half of its travel at
/// least. `curveInks`: those of all curves.
std::optional<DashedCourse> dashedBeside(const CurveTrace& solid, const CurveInk& curve,
                                         const std::vector<int>& curveInks, const PlotInks& plot);

}  // namespace detent::importer::trace
