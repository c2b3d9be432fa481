// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A vibration for display: of a press, or of another program.

#include <cstdint>
#include <optional>
#include <vector>

#include "playback/playback.h"

namespace detent::editor {

/// Sample rate of what is drawn; the sound device may have another.
inline constexpr double drawnRate_Hz = 48000;

/// A signal for display. If it could not be made, `failure` has the reason and everything else is empty.
struct DrawnSignal {
  std::uint64_t revision = 0;  ///< revision of the request, counted by its sender
  std::vector<float> samples;  ///< at drawnRate_Hz, full scale is 1
  double peak = 0;             ///< largest |sample|
  /// events of the engine at their frames; empty for a signal that no engine made
  std::vector<playback::EngineEvent> events;
  playback::PressTrace
      press;  ///< readings of the press that caused the signal; empty for a signal without a press
  playback::Spectrogram spectrogram;
  std::optional<Failure> failure;

  double duration_s() const { return static_cast<double>(samples.size()) / drawnRate_Hz; }
};

}  // namespace detent::editor
