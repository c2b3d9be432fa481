// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Help > User's guide and Help > Glossary.

#include <QDialog>
#include <QTextBrowser>

namespace detent::editor {

/// Folder of the installed documents, or of those beside the sources; empty: they are not there.
QString documentsFolder();

/// Shows the pages of the guide, which are Markdown files beside the program. GUI thread.
class GuideWindow : public QDialog {
  Q_OBJECT

 public:
  /// `folder`: documentsFolder(); without it the window says where the guide is missing.
  explicit GuideWindow(const QString& folder, QWidget* parent = nullptr);
};

/// Six pictures of what the figures of a force graph measure, drawn from a button of the model. GUI thread.
class GlossaryWindow : public QDialog {
  Q_OBJECT

 public:
  explicit GlossaryWindow(QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void drawPictures();
};

}  // namespace detent::editor
