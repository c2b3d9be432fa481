// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Speed of a press, and the button at that speed, for buttons with graphs at several speeds.

#include <optional>

#include "model/button.h"
#include "playback/offline/render_press.h"
#include "playback/prepare/prepare_program.h"

namespace detent::playback {

/// Speed of the finger in the first press of a trace that passes the marks of speed_tracker.h. Empty if no
/// press does.
std::optional<double> pressSpeed_mm_per_s(const HapticProgram& program, const PressTrace& trace);

/// A button at the speed of a press.
struct PressedButton {
  Button button;  ///< with one graph per state
  PreparedProgram prepared;
  /// none for a button with one graph per state, and if no press passes through the travel
  std::optional<double> speed_mm_per_s;
};

/// For a button with graphs at several speeds, the button at the trace's speed, or at the lowest if no press
/// passes through the travel. A stated speed that lies within the error of the press's speed uses its own
/// graph. Any other button is returned unchanged. `front` is prepared from the same button, profile and
/// settings. Failures: as prepareProgram. Allocates.
Result<PressedButton> asPressed(const Button& button, const PreparedProgram& front, const PressTrace& trace,
                                const DeviceProfile& profile, const PlaybackSettings& settings);

}  // namespace detent::playback
