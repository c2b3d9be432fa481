// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measured switches in words, in the shown units.

#include <optional>
#include <QString>

#include "editor/document/display_units.h"
#include "importer/switch_library.h"

namespace detent::editor {

/// "Bobagum, unit B, run 2".
QString titleOf(const importer::LibrarySwitch& entry);
QString kindWords(importer::SwitchKind kind);
QString licenceWords(const importer::LibrarySwitch& entry);
QString creditWords(const importer::LibrarySwitch& entry);
/// Title, credit and licence, one per line.
QString creditedTitle(const importer::LibrarySwitch& entry);
/// Text of a figure in the shown unit, without that unit; shares in %.
QString figureText(double value, KeyFigure figure, const DisplayUnits& units);
/// "53.2 ± 0.1" for "53.2"; without an error the text itself.
QString withError(const QString& shown, const std::optional<double>& sigma, KeyFigure figure,
                  const DisplayUnits& units);
/// " 9 records of 3 units: peak force 53.2 ± 1.4 cN between units."; empty for a single record.
QString spreadWords(const importer::SwitchSpread& spread, const DisplayUnits& units);
QString doubtfulScaleWords();
/// " Rated by …": ratings of people in their own words and on their own scales.
QString ratingWords(const std::vector<importer::Rating>& ratings);
/// "Peak force (cN)".
QString figureTitle(KeyFigure figure, const DisplayUnits& units);
/// A figure in the shown unit; shares in %.
double shownFigure(double value, KeyFigure figure, const DisplayUnits& units);

}  // namespace detent::editor
