// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Speed of a press, and the button at that speed, for buttons with graphs at several speeds.

#include <optional>

#include "model/button.h"
#include "playback/offline/render_press.h"
#include "playback/prepare/prepare_program.h"

namespace detent::playback {

/// Speed of the finger in the first press of a trace that goes so far, by the marks of speed_tracker.h. Empty
/// where none does.
std::optional<double> pressSpeed_mm_per_s(const HapticProgram& program, const PressTrace& trace);

/// A button as a press finds it.
struct PressedButton {
  Button button;  ///< with one graph per state
  PreparedProgram prepared;
  /// none of a button with one graph per state, nor where no press goes through its travel
  std::optional<double> speed_mm_per_s;
};

/// For a button with graphs at several speeds, the button of the trace's speed, or of the lowest if no press
/// goes through; a stated speed within the error of the press's speed takes its own graph. Any other button
/// as it is. `front` is prepared from the same three. Failures: as prepareProgram. Allocates.
Result<PressedButton> asPressed(const Button& button, const PreparedProgram& front, const PressTrace& trace,
                                const DeviceProfile& profile, const PlaybackSettings& settings);

}  // namespace detent::playback
