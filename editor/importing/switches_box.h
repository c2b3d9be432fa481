// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The switches that one plot shows, as the legend names and colours them: which one is read, and which ones
// are imported.

#include <QGroupBox>
#include <QListWidget>

#include "editor/importing/import_state.h"

namespace detent::editor {

/// Hidden for plots of one switch. The chosen row is the switch that is read and shown; ticked ones are
/// imported together, each as a button of its own. GUI thread.
class SwitchesBox : public QGroupBox {
  Q_OBJECT

 public:
  /// `state` must outlive it.
  explicit SwitchesBox(ImportState& state, QWidget* parent = nullptr);

  /// Shows the switches of the current graph.
  void follow();

 private:
  void fill(const ImportGraph& graph, const std::vector<SwitchChoice>& choices);
  void fitHeight();

  ImportState& state_;
  QListWidget* list_;
};

}  // namespace detent::editor
