// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Settings of a printed graph: purpose, size, words and units; with a preview.

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "editor/files/graph_export.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {

/// A preset fills in everything; what is changed afterwards stays. The picture follows every change. GUI
/// thread.
class GraphExportDialog : public QDialog {
  Q_OBJECT

 public:
  GraphExportDialog(Button button, const DisplayUnits& units, QWidget* parent = nullptr);

  GraphExport choice() const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QFormLayout* madeFor();
  QFormLayout* axes();
  QFormLayout* shown();
  QuantityField* axisEnd(const char* name, const QString& tip, Quantity quantity);
  void takePreset();
  void takeUnits();
  void showChoice();
  DisplayUnits units() const;
  std::optional<detent::AxisEnds> endsFrom(const QuantityField& first, const QuantityField& last,
                                           const Ticks& whole) const;
  QString refusal() const;

  Button button_;
  QComboBox *preset_, *format_, *language_, *decimalSign_, *length_, *force_, *second_, *font_;
  QCheckBox *monochrome_, *callouts_, *dimensions_;
  QuantityField *tolerance_, *toleranceForce_, *width_, *height_, *xFrom_, *xTo_, *yFrom_, *yTo_;
  QSpinBox* fontSize_;
  QLabel *picture_, *refusal_;
  QPushButton* accept_ = nullptr;
  bool filling_ = false;
};

}  // namespace detent::editor
