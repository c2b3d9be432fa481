// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Change of a button's force with speed: a force that rises against the movement damps as b(x) does, one that
// falls drives the handle.

#include "model/button.h"
#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

/// A change of force with speed as a damping, N·s/mm: above 0 it takes energy, below 0 it feeds it.
struct SpeedDamping {
  double least = 0, most = 0;
};

/// Damping of both strokes at a displacement, over all pairs of neighbouring speeds; 0 without a family, and
/// always 0 <= most, least <= 0: below the lowest speed nothing changes.
SpeedDamping speedDampingAt(const ButtonState& state, double at_mm);

/// The part that a device renders beside the button's own b(x): as much damping as its mass allows, and half
/// of what its damper takes.
SpeedDamping renderedSpeedDamping(const ButtonState& state, const ForceDeviceProfile& device, double rate_Hz);

}  // namespace detent::playback
