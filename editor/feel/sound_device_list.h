// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// List of sound devices, read off the GUI thread, because some drivers take seconds to answer.

#include <QObject>
#include <QString>
#include <thread>
#include <vector>

#include "editor/feel/feel_devices.h"

namespace detent::editor {

/// GUI thread; the devices are listed on a separate thread, one query at a time.
class SoundDeviceList : public QObject {
  Q_OBJECT

 public:
  explicit SoundDeviceList(QObject* parent = nullptr, FeelDevices devices = {});
  ~SoundDeviceList() override;  ///< waits for a running query

  void refresh();
  bool asking() const { return asking_; }
  /// Devices with an output, as last listed.
  const std::vector<playback::SoundDevice>& outputs() const { return outputs_; }
  /// The reason why there is no list, and the remedy; empty if there is a list.
  const QString& trouble() const { return trouble_; }

 signals:
  void changed();

 private:
  FeelDevices devices_;
  std::thread thread_;
  bool asking_ = false;
  std::vector<playback::SoundDevice> outputs_;
  QString trouble_;
};

}  // namespace detent::editor
