// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Two lines with one direction of colour and different strengths: black and grey, blue and pale blue.
// Directions do not separate them, because mixing with paper keeps the direction; the strength at a line's
// core does (docs/develop/decisions/0500-colours-of-curves.md).

#include <optional>
#include <vector>

#include "importer/trace/curve_trace.h"
#include "importer/trace/plot_scene.h"

namespace detent::importer::trace {

/// Level at the middles of a plane's lines; 0 without lines.
float ridgeLevel(const Plane& plane);

/// Clears lines of nearly full strength, so that paler ones remain.
void clearStrongLines(Plane& plane);

/// The paler shade of lines with this colour's direction, away from its own lines, if there are enough for a
/// curve. `coverage`: by the colour.
std::optional<PaletteColour> palerShade(const PlotScene& scene, const PaletteColour& colour,
                                        const Plane& coverage, double leastMass_px);

/// Returns true if two colours have one direction: shades of each other.
bool areShades(const PaletteColour& a, const PaletteColour& b);

/// Assigns coverage of colours with one direction to the shade whose lines it lies on.
void partShades(std::vector<Plane>& coverage, const std::vector<PaletteColour>& colours);

/// Clears what belongs to no curve of the shades: dotted or dashed gridlines, boxes. `boxes`: of legends.
void clearPlotLines(std::vector<Plane>& coverage, const std::vector<PaletteColour>& colours,
                    const PlotScene& scene, const std::vector<Box>& boxes);

/// Extends the ends of a paler line along a stronger one's edge, where they are not visible, to its ends.
void leadBeside(CurveTrace& paler, const CurveTrace& stronger);

}  // namespace detent::importer::trace
