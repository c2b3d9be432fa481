// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A small dialog for one operation on the button: fields, live preview, one undo step.

#include <functional>
#include <QDialog>
#include <QString>
#include <QStringList>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"

class QLabel;
class QPushButton;
class QTimer;

namespace detent::editor {

/// Quantity of a field. Values are always mm, N, N·s/mm.
enum class FieldKind { length, force, damping, factor, ratio, count, choice };

struct OperationField {
  QString name;
  FieldKind kind = FieldKind::factor;
  double value = 0, minimum = 0, maximum = 0;
  QString tip;
  QStringList choices;  ///< entries of FieldKind::choice; the value is an index into them
};

/// One operation of the dialog. `edit` gets the button before and the fields' values.
struct Operation {
  QString title, explanation;
  std::vector<OperationField> fields;
  std::function<Result<Button>(const Button& start, const std::vector<double>& values)> edit;
  bool slow = false;  ///< the preview waits until typing pauses
};

/// Window-modal. The document shows the preview while it is open; OK makes one step, Cancel restores exactly.
/// A refusal is shown in the dialog; the last valid preview stays, and OK waits. GUI thread.
class OperationDialog : public QDialog {
  Q_OBJECT

 public:
  OperationDialog(ButtonDocument& document, ViewSettings& settings, Operation operation,
                  QWidget* parent = nullptr);
  ~OperationDialog() override;

  std::vector<double> values() const;
  void setValue(std::size_t field, double value);
  void done(int result) override;

 private:
  QWidget* makeField(std::size_t index);
  QString fieldRefusal() const;
  void fieldChanged();
  void preview();

  ButtonDocument& document_;
  ViewSettings& settings_;
  Operation operation_;
  std::vector<QWidget*> editors_;
  QLabel* refusal_;
  QPushButton* accept_;
  QTimer* pause_;
  bool dragging_ = false;
};

}  // namespace detent::editor
