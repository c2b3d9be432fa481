// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/switch_filter.h"

#include <algorithm>
#include <QStringList>

namespace detent::editor {

QString searchedText(const importer::LibrarySwitch& entry) {
  QStringList parts;
  for (const std::string* part : {&entry.name, &entry.unit, &entry.licence, &entry.credit, &entry.source})
    parts << QString::fromStdString(*part);
  return parts.join('\n').toLower();
}

bool keeps(const SwitchFilter& filter, const importer::LibrarySwitch& entry, const QString& searched) {
  if (filter.kind && importer::kindOf(entry.figures) != *filter.kind) return false;
  const bool within = std::ranges::all_of(filter.ranges, [&](const importer::FigureRange& range) {
    const auto& value = entry.figures[range.figure];
    return value && *value >= range.low && *value <= range.high;
  });
  if (!within) return false;
  const QStringList words = filter.words.toLower().split(' ', Qt::SkipEmptyParts);
  return std::ranges::all_of(words, [&](const QString& word) { return searched.contains(word); });
}

}  // namespace detent::editor
