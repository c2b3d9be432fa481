// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button's damping b(x) as a polyline, with the values that the force law and the stability limits need.

#include <vector>

#include "model/button.h"
#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

/// Smallest damping over the whole travel; 0 without any.
double leastDamping(const std::vector<DampingPoint>& points);
/// Raises the damping to at least `least_Ns_per_mm` everywhere; returns the largest addition.
double raiseDamping(std::vector<DampingPoint>& points, double least_Ns_per_mm, double travel_mm);

/// Largest damping that a device may render: a sampled and delayed damping force must change the speed of the
/// device's mass only a little within that time.
double largestDamping_Ns_per_mm(const ForceDeviceProfile& device, double rate_Hz);

}  // namespace detent::playback
