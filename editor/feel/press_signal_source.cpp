// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/press_signal_source.h"

#include <memory>
#include <utility>

namespace detent::editor {

PressSignalSource::PressSignalSource(QObject* parent)
    : QObject(parent), requests_([this](const Waiting& next) { compute(next); }) {}

std::uint64_t PressSignalSource::request(PressSignalRequest request) {
  ++requested_;
  requests_.put({requested_, std::move(request)});
  return requested_;
}

void PressSignalSource::compute(const Waiting& next) {
  auto signal = std::make_shared<PressSignal>(pressSignalOf(next.request));
  signal->revision = next.revision;
  // Queued events for an object that is gone are dropped by Qt; the destructor waits for this thread.
  QMetaObject::invokeMethod(
      this, [this, signal] { emit ready(signal); }, Qt::QueuedConnection);
}

}  // namespace detent::editor
