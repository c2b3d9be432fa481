// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which words of the page name which trace. Private to importer/trace.

#include <vector>

#include "importer/axes/axis_calibration.h"
#include "importer/page/page.h"
#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Gives each trace the words that its legend sample stands beside; several texts of one ink parted by " / ".
void labelTraces(std::vector<CurveTrace>& traces, const AxesFound& axes, const PageView& view,
                 const PlotScene& scene);

/// Two strokes of one ink that have two words of the legend between them get one each, where the one is drawn through and the other in dashes and
/// so are the samples.
void nameByDashes(CurveTrace& first, CurveTrace& second, const AxesFound& axes, const PageView& view,
                  const PlotScene& scene);

}  // namespace detent::importer::trace
