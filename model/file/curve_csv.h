// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// CSV with the header `stroke,displacement_mm,force_N`, rows in the order travelled. For logs of force
// testers see importer/log.

#include <string>
#include <string_view>

#include "model/compare.h"
#include "model/force_graph.h"

namespace detent {

/// Samples of both strokes (samplingTolerance of the force range; vertical pieces, corners and extrema
/// exact). Numbers read back bit for bit. No rows for a missing release.
std::string csvFrom(const ForceGraph& graph);

/// Returns the rows unchanged, with any sampling and any order within a stroke. Tolerates a byte order mark,
/// CRLF and blank lines. Failure unreadableInput with the line: wrong header, wrong field count, not finite,
/// unknown stroke; noForceGraph: no rows.
Result<GraphPolylines> polylinesFromCsv(std::string_view text, const std::string& subject);

/// Returns a graph through the rows, see curveThroughDensePoints. The release must go from large to small
/// displacement. Failure noForceGraph: no press rows.
Result<ForceGraph> graphFromCsv(std::string_view text, const std::string& subject);

}  // namespace detent
