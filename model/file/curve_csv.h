// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The CSV of the programs' contract: header `stroke,displacement_mm,force_N`, rows in the order travelled.
// For force meters' own logs see importer/log.

#include <string>
#include <string_view>

#include "model/compare.h"
#include "model/force_graph.h"

namespace detent {

/// Samples of both strokes (samplingTolerance of the force range; walls, corners and extrema exact). Numbers
/// read back bit for bit. No release rows where none is known.
std::string csvFrom(const ForceGraph& graph);

/// The rows as they stand, any sampling, any order within a stroke. A byte order mark, CRLF and blank lines
/// are tolerated. Failure unreadableInput with the line: wrong header, wrong field count, not finite, unknown
/// stroke; noForceGraph: no rows.
Result<GraphPolylines> polylinesFromCsv(std::string_view text, const std::string& subject);

/// A graph through the rows: see curveThroughDensePoints. The release must come back from large to small
/// displacement. Failure noForceGraph: no press rows.
Result<ForceGraph> graphFromCsv(std::string_view text, const std::string& subject);

}  // namespace detent
