// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Steepest spring at which a device, sampled and late as it is, comes to rest by itself.

#include <vector>

#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

/// Slope in N/mm up to which the device's handle, with no finger on it and no friction, swings less and less
/// on a spring with `damping_Ns_per_mm`. The loop of handle, velocity estimate, law with its lead, delay,
/// hold and lag is simulated without encoder steps, and the slope is halved in. Damping may be below 0: a
/// force that falls with speed. The result is 5 % below the limit found; at most the device's largest slope;
/// 0 if it swings on any. `rate_Hz` > 0. Any thread; allocates; some 2 ms.
double loopLimit_N_per_mm(const ForceDeviceProfile& device, double rate_Hz, double damping_Ns_per_mm);

/// The same over a range of damping, at a few places and straight between them.
class LoopLimits {
 public:
  /// `low` <= `high`.
  LoopLimits(const ForceDeviceProfile& device, double rate_Hz, double low_Ns_per_mm, double high_Ns_per_mm);
  double at_N_per_mm(double damping_Ns_per_mm) const;
  /// Least slope limit over the whole range.
  double least_N_per_mm() const;

 private:
  double low_Ns_per_mm_, high_Ns_per_mm_;
  std::vector<double> limits_N_per_mm_;
};

}  // namespace detent::playback
