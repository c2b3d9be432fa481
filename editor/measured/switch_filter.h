// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Filter of the measured switches.

#include <optional>
#include <QString>
#include <vector>

#include "importer/switch_library.h"

namespace detent::editor {

/// A switch is shown if it passes every criterion. Plain value.
struct SwitchFilter {
  QString words;  ///< each word occurs in name, unit, licence, credit or file, in either case
  std::optional<importer::SwitchKind> kind;
  std::vector<importer::FigureRange> ranges;  ///< a switch without the figure does not pass
};

/// Text that is searched for words: one per switch, in lower case.
QString searchedText(const importer::LibrarySwitch& entry);
/// `searched`: searchedText of the entry.
bool keeps(const SwitchFilter& filter, const importer::LibrarySwitch& entry, const QString& searched);

}  // namespace detent::editor
