// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A press timed to a cue (temporal pointing, Lee & Oulasvirta 2016, 10.1145/2858036.2858143): how often it
// misses its window.

namespace detent::playback {

/// Timing of people without the influence of a button: their aim within the window, and its spread.
struct Timing {
  double aim = 0.185;    ///< mean of the press as a share of the window, from its start
  double spread = 0.09;  ///< standard deviation as a share of the interval to the cue; > 0
};

/// Share of presses outside a window of `window_s` after an interval of `interval_s` (both > 0, s). The
/// button adds its own spread of activation times `activationSpread_s` (>= 0). In closed form.
double timedPressError(double window_s, double interval_s, double activationSpread_s,
                       const Timing& timing = {});

}  // namespace detent::playback
