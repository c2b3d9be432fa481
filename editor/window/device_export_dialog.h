// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Chooses the device for a press, and shows before it is written how its format changes it.

#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "editor/files/exports.h"

namespace detent::editor {

/// The choice in the dialogue, and the ending of its file.
struct DeviceChoice {
  DeviceExport wanted;
  QString name;    ///< name of the format, for people
  QString ending;  ///< ".ahap"
};

/// Format, press and the losses of the format, recomputed with every change (10 ms). GUI thread.
class DeviceExportDialog : public QDialog {
  Q_OBJECT

 public:
  explicit DeviceExportDialog(Button button, QWidget* parent = nullptr);

  DeviceChoice choice() const;

 private:
  void showChoice();

  Button button_;
  QComboBox *format_, *rate_, *bits_;
  QSpinBox* wayDown_;
  QLabel *purpose_, *loss_;
  QFormLayout* form_;
  QPushButton* accept_ = nullptr;
};

}  // namespace detent::editor
