// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Texts in the person's language.

#include <QCoreApplication>
#include <QLocale>
#include <QSettings>

namespace detent::editor {

/// Setting with the code of the language that was chosen; empty: the system's.
inline constexpr const char* languageKey = "view/language";

/// Locale of the chosen language if `folder` has its texts, or if it is English; the system's otherwise.
QLocale chosenLocale(const QSettings& settings, const QString& folder = QStringLiteral(":/i18n"));

/// Installs detent_<language>.qm from `folder`, and Qt's own texts for `locale`, if they exist; otherwise the
/// texts stay English. The translators belong to `application`. Returns true if Detent's own texts were
/// found.
bool installTranslation(QCoreApplication& application, const QLocale& locale,
                        const QString& folder = QStringLiteral(":/i18n"));

}  // namespace detent::editor
