// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The form behind the pad: how to press, what is felt, and which devices are used.

#include <QWidget>

#include "editor/document/view_settings.h"
#include "editor/feel/feel_settings.h"
#include "editor/feel/sound_device_list.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QRadioButton;
class QShowEvent;

namespace detent::editor {

class QuantityField;

/// Shows FeelSettings and reports changes by hand; changes nothing itself. GUI thread.
class FeelSetup : public QWidget {
  Q_OBJECT

 public:
  FeelSetup(ViewSettings& view, SoundDeviceList& devices, QWidget* parent = nullptr);

  void setSettings(const FeelSettings& settings);
  const FeelSettings& settings() const { return settings_; }

  /// State of the profile file: its name and measured delay, or the reason why it could not be read.
  void setProfile(const std::optional<playback::DeviceProfile>& profile, const QString& trouble);
  /// State of the sensor; `trouble`: the reason why it could not be opened.
  void setSensor(const playback::PlayerStatus& status, const QString& trouble);
  void setBuffer(unsigned frames);
  /// Offers a port for connecting by hand, because devices are not opened before the user requests it.
  void offerPort(const QString& port);

 signals:
  void changed(const detent::editor::FeelSettings& settings);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addPressing(QFormLayout& form);
  void addFeeling(QFormLayout& form);
  void addSound(QFormLayout& form);
  void addSensor(QFormLayout& form);
  void take();  ///< reads the settings from the widgets
  void tell();
  void showChosen();
  void showUnits();
  void showDevices();
  void showPorts();
  void showDelays();
  void chooseProfile();

  ViewSettings& view_;
  SoundDeviceList& devices_;
  FeelSettings settings_;
  std::optional<playback::DeviceProfile> profile_;
  unsigned buffer_ = 0;
  bool filling_ = false, listed_ = false;

  QFormLayout* form_;
  QComboBox *drive_, *mode_, *device_, *rate_, *bufferChoice_, *port_, *baud_;
  QuantityField* full_;
  QCheckBox* followState_;
  QRadioButton *fast_, *stamped_;
  QLabel *fastDelay_, *stampedDelay_, *profileNote_, *deviceNote_, *sensorNote_;
  QPushButton *profileFile_, *noProfile_, *refresh_, *connect_;
};

}  // namespace detent::editor
