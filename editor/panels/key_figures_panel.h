// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The key figures panel: typed, kept and requested figures.

#include <QTimer>
#include <QWidget>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace detent::editor {

class TroubleLabel;
class KeyFiguresModel;
class ValueDelegate;
class ValueTable;

/// Key figures as a table for spreadsheets: name, value, unit, with tabs between them, in the units shown.
QString figuresText(const ButtonState& state, const DisplayUnits& units);

/// A table, below it a drawing of the chosen figure, and whether the requested figures are possible. GUI
/// thread.
class KeyFiguresPanel : public QWidget {
  Q_OBJECT

 public:
  KeyFiguresPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
  KeyFiguresModel& model() { return *model_; }

 signals:
  /// The user wants to set a missing operating or reset point.
  void contactsRequested();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showRefusal(const QModelIndex& index, const QString& why);
  void showMeaning();
  void showPreview();
  void showMoves();
  void layOut();
  int layOutNumbers(int column, bool narrow);
  void showRows();
  void showSolving();

  KeyFiguresModel* model_;
  ValueTable* table_;
  ValueDelegate* delegate_;
  QWidget* about_;
  QLabel *picture_, *meaning_;
  TroubleLabel* trouble_;
  QCheckBox* all_;
  QPushButton *take_, *giveUp_;
  QLabel *solving_, *moves_;
  QTimer patience_;
};

}  // namespace detent::editor
