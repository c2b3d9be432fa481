// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The part of the setup that chooses a force device.

#include <QWidget>

#include "editor/document/view_settings.h"
#include "editor/feel/feel_settings.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace detent::editor {

class QuantityField;

/// Shows ForceChoices and reports changes by hand; changes nothing itself. GUI thread.
class ForceSetup : public QWidget {
  Q_OBJECT

 public:
  explicit ForceSetup(ViewSettings& view, QWidget* parent = nullptr);

  void setChoices(const ForceChoices& choices);
  const ForceChoices& choices() const { return choices_; }

 signals:
  void changed(const detent::editor::ForceChoices& choices);

 private:
  void addDevice(QFormLayout& form);
  void addLimits(QFormLayout& form);
  void take();  ///< reads the settings from the widgets
  void chooseFirmware();
  void showRows();
  void showUnits();
  QString kind() const;

  ViewSettings& view_;
  ForceChoices choices_;
  bool filling_ = false;

  QFormLayout* form_;
  QComboBox *device_, *port_, *finger_;
  QuantityField *largest_, *step_, *turn_;
  QPushButton* firmware_;
  QCheckBox *upload_, *controller_;
  QLabel* note_;
};

}  // namespace detent::editor
