// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Exact values, typed in the user's units.

#include <QWidget>

#include "editor/canvas/graph_marks.h"
#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"

namespace detent::editor {

class TroubleLabel;
class ValuesModel;
class ValueTable;

/// A refusal is shown under the table, and the old value is restored. GUI thread.
class ValuesPanel : public QWidget {
  Q_OBJECT

 public:
  ValuesPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
  ValuesModel& model() { return *model_; }
  /// Width of all columns.
  QSize sizeHint() const override;

  /// Scrolls to a mark's row.
  void showMark(std::optional<detent::editor::MarkId> mark);

 signals:
  /// A row was chosen.
  void markChosen(detent::editor::MarkId mark);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void showRefusal(const QModelIndex& index, const QString& why);
  void layOut();  ///< makes headings as wide as the table, and columns as wide as their contents
  int widthOf(int column) const;
  void giveRoomToNames();

  ValuesModel* model_;
  ValueTable* table_;
  TroubleLabel* refusal_;
};

}  // namespace detent::editor
