// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// List of sound devices, read without stopping the window: some drivers take seconds to answer.

#include <QObject>
#include <QString>
#include <thread>
#include <vector>

#include "editor/feel/feel_devices.h"

namespace detent::editor {

/// GUI thread; asks on a thread of its own, one question at a time.
class SoundDeviceList : public QObject {
  Q_OBJECT

 public:
  explicit SoundDeviceList(QObject* parent = nullptr, FeelDevices devices = {});
  ~SoundDeviceList() override;  ///< waits for an answer that is under way

  void refresh();
  bool asking() const { return asking_; }
  /// Devices with an output, as last listed.
  const std::vector<playback::SoundDevice>& outputs() const { return outputs_; }
  /// The reason why there is no list, and the remedy; empty if there is one.
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
