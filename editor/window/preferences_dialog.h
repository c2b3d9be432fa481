// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Settings of the program in one place: units, language, theme, layout.

#include <QDialog>
#include <QFormLayout>
#include <QSettings>

#include "editor/document/view_settings.h"

namespace detent::editor {

/// Each choice applies at once, except the language, which changes at the next start. GUI thread.
class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  /// `languages`: codes of the languages that the program carries. `view` and `settings` must outlive it.
  PreferencesDialog(ViewSettings& view, QSettings& settings, const QStringList& languages,
                    QWidget* parent = nullptr);

 signals:
  void layoutResetWanted();

 private:
  void makeUnitChoices(QFormLayout& form);
  void makeLanguageChoice(QFormLayout& form, const QStringList& languages);
  void makeThemeChoice(QFormLayout& form);

  ViewSettings& view_;
  QSettings& settings_;
};

}  // namespace detent::editor
