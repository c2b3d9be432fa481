// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/performance/timed_press.h"

#include <algorithm>
#include <cmath>

#include "model/check.h"
#include "playback/performance/elementary.h"

namespace detent::playback {

double timedPressError(double window_s, double interval_s, double activationSpread_s, const Timing& timing) {
  DETENT_CHECK(window_s > 0 && interval_s > 0 && timing.spread > 0, "windows, intervals and spreads above 0");
  const double motor_s = timing.spread * interval_s;
  const double spread_s = std::sqrt(motor_s * motor_s + activationSpread_s * activationSpread_s);
  const double late_s = (1 - timing.aim) * window_s, early_s = timing.aim * window_s;
  // The shares are accurate to 1e-14, so a window that is never missed could get a slightly negative share.
  return std::max(0.0, 1 - (normalShare(late_s / spread_s) - normalShare(-early_s / spread_s)));
}

}  // namespace detent::playback
