// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button as a row of numbers: the form in which it is passed to the page's engine, which has neither files
// nor JSON. Every double is passed unchanged, so that the page plays exactly what `detent-play render`
// writes.

#include <vector>

#include "model/button.h"

namespace detent::playback {

/// First the number of states. Then, state by state: operating and reset point in mm (NaN: none), number of
/// press knots, of release knots (0: no release), and four numbers per knot: displacement in mm, force in N,
/// slope before and after in N/mm. For a button with graphs at several speeds: the number of other speeds,
/// its own speed in mm/s, and, state by state, each other speed with its two numbers of knots and the knots.
/// Names, damping and provenance are left out, because vibration does not need them.
std::vector<double> numbersOf(const Button& button);

/// The button that numbersOf() wrote, with every rule of Button checked. Failure unreadableInput: other
/// numbers.
Result<Button> buttonFrom(const std::vector<double>& numbers);

}  // namespace detent::playback
