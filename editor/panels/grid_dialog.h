// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Grid steps for snapping.

#include <QDialog>

#include "editor/document/view_settings.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {

/// Typed values apply at once, in the shown units. GUI thread.
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
