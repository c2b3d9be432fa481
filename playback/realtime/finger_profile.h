// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Press by a key, a mouse button or a pad without a force sensor: the force of a human-like finger over time.

namespace detent::playback {

/// Progress 0 to 1 for `share` 0 to 1, with zero velocity and acceleration at both ends: the profile of
/// reaching movements (Flash & Hogan, J. Neurosci. 1985). Outside that range, the value of the nearer end.
double minimumJerk(double share);

/// Converts a key press to force. Press and release follow the minimum-jerk profile of reaching movements
/// (Flash & Hogan, J. Neurosci. 1985). While the key is held, the force has the physiological tremor of 8-12
/// Hz, without randomness: the same key times always give the same readings.
struct FingerProfile {
  double peak_N = 2;        ///< > 0
  double press_s = 0.08;    ///< time from touch to the full force; > 0
  double release_s = 0.06;  ///< > 0
  double tremorOfForce = 0.01;
  double tremor_Hz = 10;
  double rate_Hz = 1000;  ///< readings per second while the finger moves; 100..10000
};

/// Force `t_s` after the key went down, if it stays down; starts from `from_N`.
double pressedForce(const FingerProfile& profile, double from_N, double t_s);
/// Force `t_s` after the key went up.
double releasedForce(const FingerProfile& profile, double from_N, double t_s);

}  // namespace detent::playback
