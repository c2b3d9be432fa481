// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The steps of the grid that dragged points snap to.

#include <QDialog>

#include "editor/document/view_settings.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {

/// What is typed holds at once, in the units shown. GUI thread.
class GridDialog : public QDialog {
  Q_OBJECT

 public:
  /// `settings` must outlive it.
  explicit GridDialog(ViewSettings& settings, QWidget* parent = nullptr);

 private:
  QuantityField* field(const char* name, Quantity quantity, double SnapSettings::*step);

  ViewSettings& settings_;
};

}  // namespace detent::editor
