// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers of the selected mark.

#include <optional>
#include <QWidget>

#include "editor/canvas/graph_marks.h"
#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/tools/tool.h"

class QLabel;

namespace detent::editor {

class TroubleLabel;
class SelectedRow;
class ValuesModel;
class ValueTable;

/// Name of the selected mark, and below it the mark's row of the table of all values, one number per line.
/// GUI thread.
class SelectionPanel : public QWidget {
  Q_OBJECT

 public:
  SelectionPanel(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);

  void showMark(std::optional<detent::editor::MarkId> mark);
  /// Opens the cell of a number for typing; returns false without a mark.
  bool edit(FirstValue first);

 signals:
  /// A cell opened by edit() was closed, with or without a typed value.
  void edited();

 private:
  void layOut();

  ValuesModel* model_;
  SelectedRow* row_;
  std::optional<MarkId> mark_;
  QLabel* title_;
  TroubleLabel* trouble_;
  ValueTable* table_;
  bool editing_ = false;  ///< a cell was opened by edit()
};

}  // namespace detent::editor
