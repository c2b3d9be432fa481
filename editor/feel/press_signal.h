// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Feel of a press of a button, as signals for display. Pure: same request, same answer.

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
  std::size_t firstState = 0;  ///< of a self-locking button: in which the press begins
};

/// A button prepared for playing, and one press of it.
struct PressSignal : DrawnSignal {
  std::shared_ptr<const playback::LiveProgram> program;  ///< program of the pressed button
  std::optional<double> speed_mm_per_s;  ///< of the press, of a button with graphs at several speeds
  std::string summary;                   ///< summary of the prepared program, in one line
  std::vector<Message> warnings;         ///< parts of the button that a program cannot hold
  bool standard = true;                  ///< playback::StandardPress, or a recorded one
  std::size_t firstState = 0;            ///< the button's state that is the program's first
  double computing_s = 0;
};

/// Some milliseconds of work; any thread.
PressSignal pressSignalOf(const PressSignalRequest& request);

}  // namespace detent::editor
