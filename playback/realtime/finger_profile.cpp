// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/finger_profile.h"

#include <cmath>
#include <numbers>

namespace detent::playback {

double minimumJerk(double share) {
  if (share <= 0) return 0;
  if (share >= 1) return 1;
  return share * share * share * (10 + share * (6 * share - 15));
}

double pressedForce(const FingerProfile& p, double from_N, double t_s) {
  const double force = from_N + (p.peak_N - from_N) * minimumJerk(t_s / p.press_s);
  const double held_s = t_s - p.press_s;
  return held_s > 0 ? force * (1 + p.tremorOfForce * std::sin(2 * std::numbers::pi * p.tremor_Hz * held_s))
                    : force;
}

double releasedForce(const FingerProfile& p, double from_N, double t_s) {
  return from_N * (1 - minimumJerk(t_s / p.release_s));
}

}  // namespace detent::playback
