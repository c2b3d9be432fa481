// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Kind of a file on the disk, before anything of it is read in full.

#include <QString>
#include <QStringList>

#include "model/result.h"

namespace detent::editor {

enum class InputKind {
  button,    ///< *.button.json
  curveCsv,  ///< CSV with the header of our own exports: opens directly
  page  ///< picture, PDF, SVG, a force meter's log, another program's project: goes to the import dialogue
};

/// Decided by the file's ending; JSON, a CSV and a file without a known ending by their first bytes. Failure
/// unreadableInput where there is no file, or it is a folder.
Result<InputKind> inputKindOf(const QString& path);

/// Filters of an open dialogue, first one: everything the editor can open.
QStringList openFilters();
/// Filters of a dialogue for sheets to import; the first one: all files that can be imported.
QStringList importFilters();
/// Files in `folder` and the folders below it that can be imported, by their endings; "2" before "10".
QStringList sheetsBelow(const QString& folder);

}  // namespace detent::editor
