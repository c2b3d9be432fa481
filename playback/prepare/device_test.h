// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The two force programs by which a device is measured.

#include "playback/realtime/force_program.h"

namespace detent::playback {

inline constexpr double relayTest_s = 3.5, chirpTest_s = 6;

/// A relay between 0 and `range_mm`, with at most the program's force.
ForceExcitation relayTest(const ForceProgram& program, double range_mm);
/// A chirp for a handle of about this mass and friction, as measured with the relay.
ForceExcitation chirpTest(const ForceProgram& program, double range_mm, double mass_kg, double friction_N);

}  // namespace detent::playback
