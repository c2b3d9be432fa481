// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Applies the user's tactile, operating and reset points to an imported graph.

#include <vector>

#include "editor/importing/corrections.h"
#include "editor/importing/import_queries.h"

namespace detent::editor {

/// Result of an import with the points of `marks`. A new tactile point begins with a small jump that is then
/// drawn into place.
struct MarkedImport {
  ImportedGraph imported;
  std::vector<Failure> refused;  ///< points that the curve does not allow where they were put
};

/// Applies marks in the given order. Without marks, report or page: the import itself. The button's
/// provenance records the changes as given, and printed values are compared with the changed button.
MarkedImport withMarks(const ImportedGraph& imported, const std::vector<MarkCorrection>& marks);

/// Adds a mark to `given`: the point at `from` is now at `to`, or is removed if `to` is empty.
std::vector<MarkCorrection> withMark(std::vector<MarkCorrection> given, MarkCorrection next);

}  // namespace detent::editor
