// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Wording of messages and failures in the editor: translated, in the user's number style and the shown units.

#include <QString>

#include "editor/document/display_units.h"
#include "model/result.h"

namespace detent::editor {

/// Translations of patterns have the context "detent".
QString inWords(const Message& message, const DisplayUnits& units = modelUnits);

/// The text with a capital letter and a full stop; empty stays empty.
QString asSentence(QString text);

/// The text cut to `longest` characters (>= 1), with an ellipsis if it was longer.
QString shortened(const QString& text, int longest);

/// Returns true if a text names an option of a program, such as "--dpi", and is therefore useless in a
/// window.
bool namesAnOption(const QString& text);

/// "SUBJECT, PLACE: PROBLEM. REMEDIES.", with the remedies that are words, not program options.
QString sentenceOf(const Failure& failure, const DisplayUnits& units = modelUnits);

}  // namespace detent::editor
