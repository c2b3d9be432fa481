// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which of the measured switches are shown.

#include <optional>
#include <QString>
#include <vector>

#include "importer/switch_library.h"

namespace detent::editor {

/// All of it is kept by a switch that is shown. Plain value.
struct SwitchFilter {
  QString words;  ///< each stands somewhere in name, unit, licence, credit or file, whatever the case
  std::optional<importer::SwitchKind> kind;
  std::vector<importer::FigureRange> ranges;  ///< a switch without the figure keeps none
};

/// Text that is searched for words: one per switch, in lower case.
QString searchedText(const importer::LibrarySwitch& entry);
/// `searched`: searchedText of the entry.
bool keeps(const SwitchFilter& filter, const importer::LibrarySwitch& entry, const QString& searched);

}  // namespace detent::editor
