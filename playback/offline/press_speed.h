// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How fast a press is, and the button as it is at that speed: what sounds of a button with graphs at several speeds.

#include <optional>

#include "model/button.h"
#include "playback/offline/render_press.h"

namespace detent::playback {

/// Of the first press in a trace that goes so far: mean from 10 to 90 % of the first state's travel. Forces become places as the engine has
/// them. Empty where none does. Allocates.
std::optional<double> pressSpeed_mm_per_s(const HapticProgram& program, const PressTrace& trace);

/// The button at a speed; a stated speed that is no farther off than a press is known takes its very graph.
Result<Button> feltAtSpeed(const Button& button, double speed_mm_per_s);

}  // namespace detent::playback
