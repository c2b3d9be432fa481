// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Change of a button's force with speed: a force that rises against the movement damps as b(x) does, one that
// falls drives the handle.

#include "model/button.h"
#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

/// A change of force with speed, expressed as damping, N·s/mm: positive values take energy, negative ones
/// supply it.
struct SpeedDamping {
  double least = 0, most = 0;
};

/// Smallest and largest damping of both strokes at a displacement, over all pairs of neighbouring speeds; 0
/// without a family. Always 0 <= most and least <= 0, because below the lowest speed nothing changes.
SpeedDamping speedDampingAt(const ButtonState& state, double at_mm);

/// The part that a device renders in addition to the button's own b(x): positive damping up to what its mass
/// allows, negative up to half of its own damping.
SpeedDamping renderedSpeedDamping(const ButtonState& state, const ForceDeviceProfile& device, double rate_Hz);

}  // namespace detent::playback
