// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Two lines in one direction of colour and of different strength: black and grey, blue and pale blue. An ink's direction does not
// tell them apart, as mixing with paper keeps it; how strong a line is at its core does (docs/develop/decisions/0500-colours-of-curves.md).

#include <optional>
#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// The level of the lines in a plane, as their middles have it; 0 where there are none.
float ridgeLevel(const Plane& plane);

/// Clears lines of nearly full strength, so that paler ones remain.
void clearStrongLines(Plane& plane);

/// The paler shade in which lines of this ink's direction are drawn away from its own, if there are as many as a curve needs.
/// `coverage`: by the ink.
std::optional<Ink> palerShade(const PlotScene& scene, const Ink& ink, const Plane& coverage,
                              double leastMass_px);

/// Whether two inks have one direction: shades of each other.
bool areShades(const Ink& a, const Ink& b);

/// Gives the coverage that inks of one direction have in common to the shade whose lines it lies on.
void partShades(std::vector<Plane>& coverage, const std::vector<Ink>& inks);

/// Clears what is no curve's of the shades' ink: gridlines in dots or dashes, boxes. `boxes`: of legends.
void clearPlotLines(std::vector<Plane>& coverage, const std::vector<Ink>& inks, const PlotScene& scene,
                    const std::vector<Box>& boxes);

/// Leads the ends of a paler line that come to lie at a stronger one's edge, where they are not seen, on beside it to its ends.
void leadBeside(CurveTrace& paler, const CurveTrace& stronger);

}  // namespace detent::importer::trace
