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

/// Installs detent_<language>.qm from `folder` and Qt's own texts for `locale`, where they are there; English
/// otherwise. The translators belong to `application`. True if Detent's own were found.
bool installTranslation(QCoreApplication& application, const QLocale& locale,
                        const QString& folder = QStringLiteral(":/i18n"));

}  // namespace detent::editor
