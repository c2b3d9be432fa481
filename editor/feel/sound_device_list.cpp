// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/sound_device_list.h"

#include <memory>

#include "editor/document/message_words.h"

namespace detent::editor {

SoundDeviceList::SoundDeviceList(QObject* parent, FeelDevices devices)
    : QObject(parent), devices_(std::move(devices)) {}

SoundDeviceList::~SoundDeviceList() {
  if (thread_.joinable()) thread_.join();
}

void SoundDeviceList::refresh() {
  if (asking_) return;
  asking_ = true;
  if (thread_.joinable()) thread_.join();
  thread_ = std::thread([this] {
    auto answer = std::make_shared<Result<std::vector<playback::SoundDevice>>>(devices_.list());
    QMetaObject::invokeMethod(
        this,
        [this, answer] {
          asking_ = false;
          outputs_.clear();
          trouble_ = *answer ? QString() : sentenceOf(answer->failure());
          if (*answer)
            for (const playback::SoundDevice& device : **answer)
              if (device.outputChannels > 0) outputs_.push_back(device);
          emit changed();
        },
        Qt::QueuedConnection);
  });
  emit changed();
}

}  // namespace detent::editor
