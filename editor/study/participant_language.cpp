// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/participant_language.h"

#include <QDir>

namespace detent::editor {

namespace {

constexpr const char* folder = ":/i18n";
constexpr const char* english = "en";

}  // namespace

ParticipantLanguage::ParticipantLanguage(const QString& code) : code_(code) {
  if (code != QLatin1String(english))
    (void)texts_.load(QStringLiteral("detent_%1").arg(code), QString::fromLatin1(folder));
}

QString ParticipantLanguage::words(const char* text) const {
  const QString found = texts_.translate("detent::editor::StudyWindow", text);
  return found.isEmpty() ? QString::fromUtf8(text) : found;
}

QStringList ParticipantLanguage::carried() {
  QStringList codes{QString::fromLatin1(english)};
  for (const QString& file : QDir(folder).entryList({"detent_*.qm"}))
    codes << file.section('_', 1).section('.', 0, 0);
  return codes;
}

}  // namespace detent::editor
