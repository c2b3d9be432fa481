// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The operations as actions; each opens its dialog on the selection.

#include <QAction>
#include <QList>
#include <QObject>
#include <QPointer>
#include <vector>

#include "editor/canvas/graph_canvas.h"
#include "editor/panels/operations.h"
#include "editor/tools/tool_box.h"

namespace detent::editor {

/// GUI thread. References must outlive it; dialogs belong to `window`.
class OperationMenu : public QObject {
  Q_OBJECT

 public:
  OperationMenu(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas, ToolBox& tools,
                QWidget& window);

  /// Includes separators. Object names: "operationAddJump", ...
  const QList<QAction*>& actions() const { return actions_; }
  /// Enables the actions that the button allows.
  void updateActions();
  /// Cancels and deletes an open dialog at once.
  void closeDialog() { delete dialog_; }

 signals:
  void said(const QString& text);

 private:
  struct Entry;
  void add(const char* name, const QString& text, const QString& tip, const QKeySequence& key,
           Operation (*make)(const OperationTarget&), bool (*offered)(const OperationTarget&));
  void addSeparator();
  OperationTarget target() const;
  void open(Operation (*make)(const OperationTarget&));

  ButtonDocument& document_;
  ViewSettings& settings_;
  GraphCanvas& canvas_;
  ToolBox& tools_;
  QWidget& window_;
  QPointer<OperationDialog> dialog_;
  bool refitWaits_ = false;  ///< a refit waits for the traced points
  QList<QAction*> actions_;
  std::vector<std::pair<QAction*, bool (*)(const OperationTarget&)>> offers_;
};

}  // namespace detent::editor
