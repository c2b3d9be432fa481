// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Finds where an increasing function passes a value.

namespace detent::playback {

/// The x in [low, high] at which the increasing `f` passes `target`, by bisection to the last bit; the nearer
/// end if it does not pass it.
template <class Function>
double whereRisingPasses(double target, double low, double high, const Function& f) {
  constexpr int halvings = 200;
  for (int i = 0; i < halvings; ++i) {
    const double middle = low + (high - low) / 2;
    (f(middle) < target ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

}  // namespace detent::playback
