// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A press in time with a cue (temporal pointing, Lee & Oulasvirta 2016, 10.1145/2858036.2858143): how often
// it misses its window.

namespace detent::playback {

/// People without a button: where in the window they aim, and how exactly.
struct Timing {
  double aim = 0.185;    ///< mean of the press as a share of the window, from its start
  double spread = 0.09;  ///< standard deviation as a share of the interval to the cue; > 0
};

/// Share of presses outside a window of `window_s` after an interval of `interval_s` (both > 0, s), the
/// button adding its own spread of activation times `activationSpread_s` (>= 0). In closed form.
double timedPressError(double window_s, double interval_s, double activationSpread_s,
                       const Timing& timing = {});

}  // namespace detent::playback
