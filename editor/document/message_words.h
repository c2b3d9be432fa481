// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Messages and failures in words for the person at the editor: translated, in their number style, in the units shown.

#include <QString>

#include "editor/document/display_units.h"
#include "model/result.h"

namespace detent::editor {

inline constexpr DisplayUnits modelUnits{LengthUnit::millimetre, ForceUnit::newton};

/// A pattern's translation is looked up under the context "detent".
QString inWords(const Message& message, const DisplayUnits& units = modelUnits);

/// With a capital letter and a full stop; empty stays empty.
QString asSentence(QString text);

/// At most `longest` characters (>= 1), the last of a longer one an ellipsis.
QString shortened(const QString& text, int longest);

/// "SUBJECT, PLACE: PROBLEM. REMEDIES.": those remedies that are words, not options of a program.
QString sentenceOf(const Failure& failure, const DisplayUnits& units = modelUnits);

}  // namespace detent::editor
