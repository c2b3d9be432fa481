// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Panel for data stored beside a button: notes, named versions, and links.

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {

class GraphCanvas;

/// Every change is an undo step. GUI thread.
class AnnotationsPanel : public QWidget {
  Q_OBJECT

 public:
  /// All must outlive it; a new note is placed at the selection on the canvas.
  AnnotationsPanel(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas);

 signals:
  void said(const QString& text);
  /// A version is opened as a button of its own.
  void versionOpened(const detent::Button& version);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* notesBox();
  QWidget* versionsBox();
  QWidget* linksBox();
  QPushButton* addButton(QLayout& row, const char* name, const QString& text, const QString& tip);
  void follow();
  void fillNotes();
  void fillVersions();
  void followLinks();
  double offset_N() const;
  void showOffset();
  void addNote();
  void keepVersion();
  void goBack();
  void openVersion();
  void renamed(QTreeWidgetItem* item);
  void link(const EditLinks& links, const QString& label, double lower_N = 0);
  /// -1: none.
  static int chosen(const QTreeWidget& list);

  ButtonDocument& document_;
  ViewSettings& settings_;
  GraphCanvas& canvas_;
  QTreeWidget *notes_, *versions_;
  QLineEdit *noteText_, *versionName_;
  QPushButton *removeNote_ = nullptr, *goBack_ = nullptr, *openVersion_ = nullptr, *removeVersion_ = nullptr,
              *unpin_ = nullptr;
  QCheckBox *oneEnd_, *releaseFollows_;
  QuantityField* offset_;
  QLabel* pins_;
  bool filling_ = false;
};

}  // namespace detent::editor
