// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The plot's own lines in one ink: how thick they are from place to place, and which come in dots or dashes. Private to importer/trace.

#include <functional>
#include <vector>

#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

constexpr double kLineTimes = 1.35;  ///< a plot's own line is drawn no thicker than so, of what it usually is

struct PixelAt {
  int x = 0, y = 0;
};

/// How thick the ink is along a column or row of the area, pixel by pixel.
std::vector<double> runsAlong(const InkOnArea& ink, const PlotArea& area, double at, bool plumb);

/// Visits pixels `along` a line at `at`, so thick as it may be.
void forPixelsAcross(const PlotArea& area, int along, double at, double most_px, bool plumb,
                     const std::function<void(int, int)>& visit);

/// The ink of gridlines of dots or dashes at the numbers of the axes: ink and gaps take turns along nearly all of them. Where one is
/// drawn through, something else stands on it.
std::vector<PixelAt> dottedLines(const InkOnArea& ink, const PlotScene& scene);

}  // namespace detent::importer::trace
