// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/preferences_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/document/form_widgets.h"
#include "editor/feel/setup_widgets.h"
#include "editor/quantity/offered_units.h"
#include "editor/window/translation.h"

namespace detent::editor {

PreferencesDialog::PreferencesDialog(ViewSettings& view, QSettings& settings, const QStringList& languages,
                                     QWidget* parent)
    : QDialog(parent), view_(view), settings_(settings) {
  setObjectName("preferences");
  setWindowTitle(tr("Preferences"));
  constexpr int least_px = 380;  // the note on the language has two lines
  setMinimumWidth(least_px);
  auto* form = new QFormLayout;
  makeUnitChoices(*form);
  makeThemeChoice(*form);
  makeLanguageChoice(*form, languages);
  auto* reset =
      plainButton("preferencesReset", tr("&Reset"), tr("Move all panels back to their initial places"));
  connect(reset, &QPushButton::clicked, this, &PreferencesDialog::layoutResetWanted);
  auto* row = new QHBoxLayout;
  row->addWidget(reset);
  row->addStretch();
  form->addRow(tr("Layout of the window:"), row);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addStretch();
  layout->addWidget(buttons);
}

void PreferencesDialog::makeUnitChoices(QFormLayout& form) {
  QComboBox* length = comboBox("preferencesLength", tr("Unit of all displacements that are shown or typed"));
  for (const LengthUnit unit : offeredLengthUnits)
    addChoice(length, unitText(symbolOf(unit)), static_cast<int>(unit));
  QComboBox* force = comboBox("preferencesForce", tr("Unit of all forces that are shown or typed"));
  for (const ForceUnit unit : offeredForceUnits)
    addChoice(force, unitText(symbolOf(unit)), static_cast<int>(unit));
  const auto follow = [this, length, force] {
    select(length, static_cast<int>(view_.units().length));
    select(force, static_cast<int>(view_.units().force));
  };
  follow();
  connect(&view_, &ViewSettings::changed, this, follow);
  connect(length, &QComboBox::activated, this, [this, length] {
    DisplayUnits units = view_.units();
    units.length = static_cast<LengthUnit>(length->currentData().toInt());
    view_.setUnits(units);
  });
  connect(force, &QComboBox::activated, this, [this, force] {
    DisplayUnits units = view_.units();
    units.force = static_cast<ForceUnit>(force->currentData().toInt());
    view_.setUnits(units);
  });
  form.addRow(tr("&Displacement:"), length);
  form.addRow(tr("&Force:"), force);
}

void PreferencesDialog::makeThemeChoice(QFormLayout& form) {
  QComboBox* theme = comboBox("preferencesTheme", tr("Light or dark window"));
  addChoice(theme, tr("same as system"), static_cast<int>(Appearance::system));
  addChoice(theme, tr("light"), static_cast<int>(Appearance::light));
  addChoice(theme, tr("dark"), static_cast<int>(Appearance::dark));
  const auto follow = [this, theme] { select(theme, static_cast<int>(view_.appearance())); };
  follow();
  connect(&view_, &ViewSettings::changed, this, follow);
  connect(theme, &QComboBox::activated, this,
          [this, theme] { view_.setAppearance(static_cast<Appearance>(theme->currentData().toInt())); });
  form.addRow(tr("&Theme:"), theme);
}

void PreferencesDialog::makeLanguageChoice(QFormLayout& form, const QStringList& languages) {
  QComboBox* language = comboBox("preferencesLanguage", tr("Language of all texts and format of numbers"));
  addChoice(language, tr("same as system"), QString());
  for (const QString& code : languages) {
    QString name = QLocale(code).nativeLanguageName();
    if (code == QLatin1String("en")) name = QStringLiteral("English");  // Qt adds its country
    addChoice(language, name.replace(0, 1, name.left(1).toUpper()), code);
  }
  select(language, settings_.value(languageKey).toString());
  QLabel* note = noteLabel("preferencesLanguageNote");
  note->setText(tr("The language changes when Detent is restarted."));
  connect(language, &QComboBox::activated, this,
          [this, language] { settings_.setValue(languageKey, language->currentData()); });
  form.addRow(tr("Lan&guage:"), language);
  form.addRow(QString(), note);
}

}  // namespace detent::editor
