// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/prompts.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QInputDialog>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>

#include "editor/library/template_dialog.h"

namespace detent::editor {
namespace {

struct Questions {
  Q_DECLARE_TR_FUNCTIONS(Questions)
};

}  // namespace

SaveChoice Prompts::unsaved(QWidget* parent, const QStringList& titles) {
  QMessageBox box(parent);
  box.setObjectName("unsavedQuestion");
  box.setIcon(QMessageBox::Question);
  box.setWindowTitle(Questions::tr("Unsaved changes"));
  box.setText(titles.size() == 1
                  ? Questions::tr("Save the changes to \u201c%1\u201d?").arg(titles.first())
                  : Questions::tr("Save the changes to %n buttons?", "", static_cast<int>(titles.size())));
  box.setInformativeText(titles.size() == 1 ? Questions::tr("If you do not save them, the changes are lost.")
                                            : titles.join(", "));
  box.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return SaveChoice::save;
    case QMessageBox::Discard:
      return SaveChoice::discard;
    default:
      return SaveChoice::cancel;
  }
}

QStringList Prompts::filesToOpen(QWidget* parent, const QString& title, const QString& folder,
                                 const QStringList& filters) {
  return QFileDialog::getOpenFileNames(parent, title, folder, filters.join(QStringLiteral(";;")));
}

QString Prompts::folder(QWidget* parent, const QString& title, const QString& at) {
  return QFileDialog::getExistingDirectory(parent, title, at);
}

QString Prompts::fileToSave(QWidget* parent, const QString& title, const QString& suggested,
                            const QString& filter, QString* chosen) {
  return QFileDialog::getSaveFileName(parent, title, suggested, filter, chosen);
}

bool Prompts::confirm(QWidget* parent, const QString& question, const QString& act) {
  QMessageBox box(QMessageBox::Warning, Questions::tr("Detent"), question, QMessageBox::Cancel, parent);
  box.setObjectName("confirmQuestion");
  const QPushButton* yes = box.addButton(act, QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == yes;
}

std::optional<Button> Prompts::newButton(QWidget* parent) {
  TemplateDialog dialog(parent);
  if (dialog.exec() != QDialog::Accepted) return {};
  return dialog.chosen().button;
}

std::optional<DeviceChoice> Prompts::deviceExport(QWidget* parent, const Button& button) {
  DeviceExportDialog dialog(button, parent);
  return dialog.exec() == QDialog::Accepted ? std::optional(dialog.choice()) : std::nullopt;
}

std::optional<GraphExport> Prompts::graphExport(QWidget* parent, const Button& button,
                                                const DisplayUnits& units) {
  GraphExportDialog dialog(button, units, parent);
  return dialog.exec() == QDialog::Accepted ? std::optional(dialog.choice()) : std::nullopt;
}

std::optional<std::string> Prompts::magneticKey(QWidget* parent, const Button& button,
                                                const DisplayUnits& units, MagneticChoice& choice) {
  MagneticDialog dialog(button, units, choice, parent);
  const bool accepted = dialog.exec() == QDialog::Accepted;
  choice = dialog.choice();  // also of a cancelled export: people study the key, then edit the button
  return accepted ? std::optional(dialog.header()) : std::nullopt;
}

bool Prompts::printer(QWidget* parent, QPrinter& printer) {
  return QPrintDialog(&printer, parent).exec() == QDialog::Accepted;
}

std::optional<QString> Prompts::text(QWidget* parent, const QString& title, const QString& label,
                                     const QString& now) {
  bool accepted = false;
  const QString text = QInputDialog::getText(parent, title, label, QLineEdit::Normal, now, &accepted);
  return accepted ? std::optional(text) : std::nullopt;
}

}  // namespace detent::editor
