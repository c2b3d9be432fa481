// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An unfinished import as a value that can be written to the disk, because corrections are work.

#include <optional>
#include <QByteArray>
#include <QString>
#include <vector>

#include "editor/importing/corrections.h"
#include "editor/importing/import_queries.h"

namespace detent::editor {

/// Corrections by hand of one graph.
struct DraftGraph {
  GraphId id;
  Corrections corrections;
  bool framedByHand = false;  ///< the frame was drawn by the user, not found
  friend bool operator==(const DraftGraph&, const DraftGraph&) = default;
};

struct ImportDraft {
  QString path;     ///< path of the sheet; empty for a pasted picture
  QString picture;  ///< file of a pasted picture; empty for a sheet
  importer::Quality quality = importer::Quality::standard;
  std::optional<GraphId> current;
  std::vector<DraftGraph> graphs;  ///< graphs with corrections
  /// Returns true if no work would be lost with the draft.
  bool empty() const { return graphs.empty(); }
  friend bool operator==(const ImportDraft&, const ImportDraft&) = default;
};

QByteArray textOf(const ImportDraft& draft);
/// nullopt for any other text. Drafts of another version are refused.
std::optional<ImportDraft> draftFrom(const QByteArray& text);

}  // namespace detent::editor
