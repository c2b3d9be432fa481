// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button's damping b(x) as a polyline: what both the force law and its stability ask of it.

#include <vector>

#include "model/button.h"
#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

/// Smallest over the whole travel; 0 without any.
double leastDamping(const std::vector<DampingPoint>& points);
/// Makes it nowhere less than `least_Ns_per_mm`; gives the largest addition.
double raiseDamping(std::vector<DampingPoint>& points, double least_Ns_per_mm, double travel_mm);

/// Largest damping of a device: sampled and delayed damping must stay a small part of the effect of its mass
/// in that time.
double largestDamping_Ns_per_mm(const ForceDeviceProfile& device, double rate_Hz);

}  // namespace detent::playback
