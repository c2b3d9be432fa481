// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button that feels different at different speeds (FDVV: Liao, Kim, Lee and Oulasvirta, CHI 2020): two to four force graphs at stated
// speeds. Between two of them the force at a place is linear in speed, beyond the outermost it is theirs.

#include <cstddef>
#include <optional>
#include <vector>

#include "model/button.h"

namespace detent {

/// The stated speeds, mm/s, rising; empty for a button with one graph per state. The same in all states.
std::vector<double> speedsOf(const Button& button);
std::vector<double> speedsOf(const ButtonState& state);

/// A state's graph at the `index`th of its speeds; at 0 its only one.
const ForceGraph& graphAt(const ButtonState& state, std::size_t index);

/// Two stated speeds and how far a speed lies between them: 0 at the lower, 1 at the upper, held outside.
struct SpeedPlace {
  std::size_t lower = 0, upper = 0;
  double share = 0;
};
/// `speeds` as above, not empty; `speed_mm_per_s` finite.
SpeedPlace placeOf(const std::vector<double>& speeds, double speed_mm_per_s);

/// The button as it is pressed and released at one speed, with one graph per state. Exact: the pieces of two cubics are cubic. At a stated
/// speed its very graph, and of a button without a family itself. Failure wrongUsage for a speed that is not finite and > 0.
Result<Button> atSpeed(const Button& button, double speed_mm_per_s);

/// One button of several, one per speed (mm/s), in any order; their own families, if any, are left out. Name, points, damping and provenance are
/// the first one's, and its graphs stand for the button where no speed is known. Failures: wrongUsage for numbers that do not match or fewer
/// than two; a broken rule of Button.
Result<Button> familyOf(const std::vector<Button>& buttons, const std::vector<double>& speeds_mm_per_s);

/// The same button with the graphs at another of its speeds in front: those that edits, figures and what knows no speed take. `index` of
/// speedsOf (checked).
Button broughtForward(const Button& button, std::size_t index);

}  // namespace detent
