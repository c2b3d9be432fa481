// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/press_signal_source.h"

#include <memory>

namespace detent::editor {

// Reports outdated results too, so that the waveform follows a drag.
PressSignalSource::PressSignalSource(QObject* parent)
    : QObject(parent), answers_(this, [this](const auto& query) {
        auto signal = std::make_shared<PressSignal>(pressSignalOf(query.request));
        signal->revision = query.revision;
        query.tellAnyway([this, signal] { emit ready(signal); });
      }) {}

}  // namespace detent::editor
