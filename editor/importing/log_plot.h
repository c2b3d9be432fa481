// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A force meter's log has no page: its points and the fit are drawn as a plain plot.

#include <QWidget>

#include "editor/document/view_settings.h"
#include "editor/importing/import_state.h"

namespace detent::editor {

class LogPlot : public QWidget {
  Q_OBJECT

 public:
  /// Both must outlive it.
  LogPlot(ImportState& state, ViewSettings& settings, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ImportState& state_;
  ViewSettings& settings_;
};

}  // namespace detent::editor
