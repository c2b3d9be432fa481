// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Adapts a button to what a device can render: slopes are limited, damping and the passivity controller are
// added where the measured profile or the link requires it. A button that still cannot be rendered is
// refused, with a remedy.

#include "model/button.h"
#include "model/result.h"
#include "playback/force_feedback.h"
#include "playback/prepare/prepare_force.h"
#include "playback/prepare/stability.h"

namespace detent::playback {

/// A button prepared for a device, and for its link if the link is the limit.
struct FittedForce {
  PreparedForce prepared;
  ForceDeviceProfile device;
  ForceLinkPace pace;
};

/// The failure for a button of which no useful force is stable: the limit of the device, the need of the
/// button, and the remedy. For a slow link it states whether this computer or the device causes the delay.
Failure tooSteepFor(const ForceDeviceProfile& device, const ForceLinkPace& pace, const MarginPoint& least,
                    double needed_N_per_mm);

/// The nearest button that the stability margin allows at the device's rate. Failure deviceTrouble if too
/// little of its force remains to be felt.
Result<FittedForce> fittedTo(const Button& button, const ForceDeviceProfile& device,
                             const ForceSettings& settings, const ForceLinkPace& pace);

/// The button, or the nearest one that is stable by the device's measured profile, damped where it would give
/// energy. The values of a preset are guesses, so a preset limits nothing.
Result<FittedForce> keptTo(const ForceDeviceProfile& profile, const Button& button,
                           const ForceSettings& settings, PreparedForce prepared);

}  // namespace detent::playback
