// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/press_signal_source.h"

namespace detent::editor {

PressSignalSource::PressSignalSource(QObject* parent) : QObject(parent) {}

PressSignalSource::~PressSignalSource() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_one();
  if (worker_.joinable()) worker_.join();
}

std::uint64_t PressSignalSource::request(PressSignalRequest request) {
  ++requested_;
  {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(Waiting{requested_, std::move(request)});
  }
  if (!worker_.joinable()) worker_ = std::thread([this] { run(); });
  wake_.notify_one();
  return requested_;
}

void PressSignalSource::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return stopping_ || waiting_.has_value(); });
    if (stopping_) return;
    const Waiting next = *std::exchange(waiting_, std::nullopt);
    lock.unlock();
    auto signal = std::make_shared<PressSignal>(pressSignalOf(next.request));
    signal->revision = next.revision;
    // Queued events for an object that is gone are dropped by Qt; the destructor waits for this thread.
    QMetaObject::invokeMethod(
        this, [this, signal] { emit ready(signal); }, Qt::QueuedConnection);
    lock.lock();
  }
}

}  // namespace detent::editor
