// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button that feels different at different speeds (FDVV: Liao, Kim, Lee and Oulasvirta, CHI 2020): two to
// four force graphs at stated speeds. Between two speeds the force at a displacement is linear in speed;
// beyond the outermost it is constant.

#include <cstddef>
#include <optional>
#include <vector>

#include "model/button.h"

namespace detent {

/// Returns the stated speeds, mm/s, rising; empty for one graph per state. The same in all states.
std::vector<double> speedsOf(const Button& button);
std::vector<double> speedsOf(const ButtonState& state);

/// Returns the graph at the `index`th speed; index 0 if the state has only one.
const ForceGraph& graphAt(const ButtonState& state, std::size_t index);

/// Interpolation between two stated speeds: 0 at the lower, 1 at the upper, clamped.
struct SpeedPlace {
  std::size_t lower = 0, upper = 0;
  double share = 0;
};
/// `speeds`: as returned by speedsOf, not empty; `speed_mm_per_s`: finite.
SpeedPlace placeOf(const std::vector<double>& speeds, double speed_mm_per_s);

/// Returns the button at one speed, with one graph per state. Exact, because a mix of two cubics is cubic. At
/// a stated speed it is that graph; without a family the button itself. Failure wrongUsage for a speed that
/// is not finite and > 0.
Result<Button> atSpeed(const Button& button, double speed_mm_per_s);

/// Combines buttons measured at different speeds (mm/s), in any order; their own families are dropped. Name,
/// points, damping and provenance are the first one's, and its graphs are used where no speed is known.
/// Failures: wrongUsage for mismatched numbers or fewer than two; a broken rule of Button.
Result<Button> familyOf(const std::vector<Button>& buttons, const std::vector<double>& speeds_mm_per_s);

/// Returns the same button with the graphs at another speed as the ones that edits, figures and code without
/// speeds use. `index` of speedsOf (checked).
Button broughtForward(const Button& button, std::size_t index);

}  // namespace detent
