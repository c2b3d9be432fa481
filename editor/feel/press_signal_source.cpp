// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/press_signal_source.h"

#include <memory>

namespace detent::editor {

// Outdated results are reported too: while a hand drags, the waveform follows it.
PressSignalSource::PressSignalSource(QObject* parent)
    : QObject(parent), answers_(this, [this](const auto& asked) {
        auto signal = std::make_shared<PressSignal>(pressSignalOf(asked.request));
        signal->revision = asked.revision;
        asked.tellAnyway([this, signal] { emit ready(signal); });
      }) {}

}  // namespace detent::editor
