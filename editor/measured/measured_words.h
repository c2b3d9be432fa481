// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measured switches in the person's words and units.

#include <QString>

#include "editor/document/display_units.h"
#include "importer/switch_library.h"

namespace detent::editor {

/// "Bobagum, unit B, run 2".
QString titleOf(const importer::LibrarySwitch& entry);
QString kindWords(importer::SwitchKind kind);
QString licenceWords(const importer::LibrarySwitch& entry);
QString creditWords(const importer::LibrarySwitch& entry);
/// Title, credit and licence, a line each.
QString creditedTitle(const importer::LibrarySwitch& entry);
/// In the unit shown, without it; a share in %.
QString figureText(double value, KeyFigure figure, const DisplayUnits& units);
/// "Peak force (cN)".
QString figureTitle(KeyFigure figure, const DisplayUnits& units);
/// A figure as it is shown: in the unit, a share in %.
double shownFigure(double value, KeyFigure figure, const DisplayUnits& units);

}  // namespace detent::editor
