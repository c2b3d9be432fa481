// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A button as a device bears it: slopes limited, damped and with the passivity controller where its measured
// profile or its link asks for that, else refused with what would carry the button.

#include "model/button.h"
#include "model/result.h"
#include "playback/force_feedback.h"
#include "playback/prepare/prepare_force.h"
#include "playback/prepare/stability.h"

namespace detent::playback {

/// A button prepared for a device, and for the link where that is what decides.
struct FittedForce {
  PreparedForce prepared;
  ForceDeviceProfile device;
  ForceLinkPace pace;
};

/// The failure of a button for which no useful force is stable: the limit of the device, the need of the
/// button, and the remedy. Of a slow link it says whether this computer or the device is late.
Failure tooSteepFor(const ForceDeviceProfile& device, const ForceLinkPace& pace, const MarginPoint& least,
                    double needed_N_per_mm);

/// The nearest button that the margin allows at the device's rate. Failure deviceTrouble if
/// that is not worth feeling.
Result<FittedForce> fittedTo(const Button& button, const ForceDeviceProfile& device,
                             const ForceSettings& settings, const ForceLinkPace& pace);

/// The button, or the nearest one that the device's measured profile bears, damped where it would give
/// energy. A preset is a guess and limits nothing.
Result<FittedForce> keptTo(const ForceDeviceProfile& profile, const Button& button,
                           const ForceSettings& settings, PreparedForce prepared);

}  // namespace detent::playback
