// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The plot's own lines in one colour: their thickness, and which are dotted or dashed. Private to
// importer/trace.

#include <functional>
#include <vector>

#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

constexpr double kLineTimes = 1.35;  ///< limit of a plot line's thickness relative to its usual one

struct PixelAt {
  int x = 0, y = 0;
};

/// Thickness along a column or row of the area, per pixel.
std::vector<double> runsAlong(const ColourOnArea& coverage, const PlotArea& area, double at, bool plumb);

/// Visits the pixels across a line at `at`, position `along`, up to its largest thickness.
void forPixelsAcross(const PlotArea& area, int along, double at, double most_px, bool plumb,
                     const std::function<void(int, int)>& visit);

/// Pixels of dotted or dashed gridlines at the tick labels: marks and gaps alternate along nearly all of
/// them. A solid one has something else on it.
std::vector<PixelAt> dottedLines(const ColourOnArea& coverage, const PlotScene& scene);

}  // namespace detent::importer::trace
