// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Assigns words of the page to traces. Private to importer/trace.

#include <vector>

#include "importer/axes/axis_calibration.h"
#include "importer/page/page.h"
#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Gives each trace the words beside its legend key; several texts of one colour separated by " / ".
void labelTraces(std::vector<CurveTrace>& traces, const AxesFound& axes, const PageView& view,
                 const PlotScene& scene);

/// Gives two strokes of one colour one word each if two words of the legend belong to them, one stroke and
/// one key being solid, the others dashed.
void nameByDashes(CurveTrace& first, CurveTrace& second, const AxesFound& axes, const PageView& view,
                  const PlotScene& scene);

}  // namespace detent::importer::trace
