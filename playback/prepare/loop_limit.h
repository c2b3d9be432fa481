// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Steepest spring on which a device, sampled and delayed as it is, comes to rest by itself.

#include <vector>

#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

/// Largest slope in N/mm at which oscillations of the device's handle, without finger and friction, decay on
/// a spring with `damping_Ns_per_mm`. The loop of handle, velocity estimate, law with prediction, delay, hold
/// and lag is simulated without encoder steps, and the slope is found by bisection. Damping may be negative:
/// a force that decreases with speed. The result is 5 % below the limit found and at most the device's
/// largest slope; 0 if no slope is stable. `rate_Hz` > 0. Any thread; allocates; some 2 ms.
double loopLimit_N_per_mm(const ForceDeviceProfile& device, double rate_Hz, double damping_Ns_per_mm);

/// Slope times encoder step that a friction of 1 N holds: 2 for a spring (Abbott and Okamura 2005). It is
/// less here, because prediction and damping of the law also act on each step (decision 1101).
inline constexpr double heldByFriction = 1.4;

/// The same limit over a range of damping, computed at a few values and linear between them.
class LoopLimits {
 public:
  /// `low` <= `high`.
  LoopLimits(const ForceDeviceProfile& device, double rate_Hz, double low_Ns_per_mm, double high_Ns_per_mm);
  double at_N_per_mm(double damping_Ns_per_mm) const;
  /// Smallest limit over the whole range.
  double least_N_per_mm() const;

 private:
  double low_Ns_per_mm_, high_Ns_per_mm_;
  std::vector<double> limits_N_per_mm_;
};

}  // namespace detent::playback
