// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Press by a key, a mouse button or a pad without a force sensor: the force of a human-like finger over time.

namespace detent::playback {

/// 0 to 1 over `share` 0 to 1 with no jerk at the ends: the profile of reaching movements (Flash & Hogan, J.
/// Neurosci. 1985). Outside it stays at the nearer end.
double minimumJerk(double share);

/// Turns a key press into force. Press and release follow the minimum-jerk profile of reaching movements
/// (Flash & Hogan, J. Neurosci. 1985); while held, the force carries the 8-12 Hz physiological tremor,
/// without chance: a given sequence of key times gives one sequence of readings.
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
