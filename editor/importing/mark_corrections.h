// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tactile, operating and reset points as a person has them, put into what was read off the page.

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

/// `given` with one more: a found or given point that was `from` somewhere is `to` somewhere else now, or
/// nowhere.
std::vector<MarkCorrection> withMark(std::vector<MarkCorrection> given, MarkCorrection next);

}  // namespace detent::editor
