// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Signals of a press of a button, for display. Pure: the same request gives the same answer.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/feel/drawn_signal.h"

namespace detent::editor {

struct PressSignalRequest {
  Button button;
  playback::DeviceProfile profile;
  playback::PlaybackSettings settings;
  std::shared_ptr<const playback::PressTrace> press = nullptr;  ///< null: the standard press
  std::size_t firstState = 0;  ///< state of a self-locking button in which the press begins
};

/// A button prepared for playing, and one press of it.
struct PressSignal : DrawnSignal {
  std::shared_ptr<const playback::LiveProgram> program;  ///< program of the pressed button
  std::optional<double> speed_mm_per_s;  ///< speed of the press, if the button has graphs at several speeds
  std::string summary;                   ///< summary of the prepared program, in one line
  std::vector<Message> warnings;         ///< parts of the button that a program cannot hold
  bool standard = true;                  ///< true: playback::StandardPress; false: a recorded press
  std::size_t firstState = 0;            ///< index of the button's state that is the first one of the program
  double computing_s = 0;
};

/// Some milliseconds of work; any thread.
PressSignal pressSignalOf(const PressSignalRequest& request);

}  // namespace detent::editor
