// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Wording of warnings about a button, in the shown units.

#include <QString>

#include "editor/document/display_units.h"
#include "importer/importer.h"
#include "model/validation.h"

namespace detent::editor {

/// One sentence: "The release lies 4.2 cN above the press at 1.25 mm." `button` names the states.
QString wordsOf(const Warning& warning, const Button& button, const DisplayUnits& units);

/// "Operating force: the sheet says 50 cN (35 to 65 cN), the graph has 52.3 cN."
QString wordsOf(const importer::SpecCheck& check, const DisplayUnits& units);

}  // namespace detent::editor
