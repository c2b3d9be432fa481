// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a press of a button feels like, as signals to look at. Pure: same request, same answer.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playback/playback.h"

namespace detent::editor {

/// Sample rate of what is drawn; the sound device may have another.
inline constexpr double drawnRate_Hz = 48000;

struct PressSignalRequest {
  Button button;
  playback::DeviceProfile profile;
  playback::PlaybackSettings settings;
  std::shared_ptr<const playback::PressTrace> press = nullptr;  ///< null: the standard press
  std::size_t firstState = 0;  ///< of a self-locking button: in which the press begins
};

/// A button prepared for playing, and one press of it. Where something could not
/// be done `failure` says so and everything else is empty.
struct PressSignal {
  std::uint64_t revision = 0;  ///< of the request, counted by PressSignalSource
  std::shared_ptr<const playback::HapticProgram> program;
  std::string summary;            ///< what was prepared, in one line
  std::vector<Message> warnings;  ///< what did not fit a program
  std::vector<float> samples;     ///< at drawnRate_Hz, full scale is 1
  double peak = 0;                ///< largest |sample|
  std::vector<playback::EngineEvent> events;
  playback::PressTrace press;  ///< what was pressed with
  bool standard = true;        ///< playback::StandardPress, or a recorded one
  std::size_t firstState = 0;  ///< the button's state that is the program's first
  playback::Spectrogram spectrogram;
  std::optional<Failure> failure;
  double computing_s = 0;

  double duration_s() const { return static_cast<double>(samples.size()) / drawnRate_Hz; }
};

/// Some milliseconds of work; any thread.
PressSignal pressSignalOf(const PressSignalRequest& request);

}  // namespace detent::editor
