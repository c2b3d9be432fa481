// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button as a row of numbers: how it enters the page's engine, which has no files and no JSON. Every double
// as it is, so that the page plays what `detent-play render` writes.

#include <vector>

#include "model/button.h"

namespace detent::playback {

/// State by state: operating and reset point in mm (NaN: none), number of press knots, of release knots (0:
/// none is known), then four numbers a knot: displacement in mm, force in N, slope before and after in N/mm.
/// In front of all the number of states. Of a button with graphs at several speeds follow the number of other
/// speeds, the own one in mm/s, and state by state each other speed with its two numbers of knots and the
/// knots. Names, damping and provenance are not in it: vibration needs none of them.
std::vector<double> numbersOf(const Button& button);

/// The way back, with every rule of Button checked. Failure unreadableInput: numbers that numbersOf did not
/// write.
Result<Button> buttonFrom(const std::vector<double>& numbers);

}  // namespace detent::playback
