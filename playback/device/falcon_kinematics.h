// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The Novint Falcon's three legs (Stamper's parallel manipulator): angles of the thighs <-> place of the
// handle, torques of a force. Lengths after libnifalcon (BSD-3), FalconGeometry.h;
// docs/develop/decisions/1103-falcon.md.

#include <array>
#include <optional>

namespace detent::playback {

/// x to the right, y up, z from the device to the person; 0 in the middle of the legs' base.
using FalconPlace_mm = std::array<double, 3>;
/// Angles of the three thighs, rad.
using FalconAngles_rad = std::array<double, 3>;

/// A thigh's angle at its encoder's count (homed).
double falconAngle_rad(int counts);

/// Inverse kinematics, closed form. None outside the reach.
std::optional<FalconAngles_rad> falconAngles_rad(const FalconPlace_mm& place_mm);

/// Forward kinematics by Newton's method, to 1e-10 mm. `near_mm`: the previous position of the handle. None
/// where the legs do not meet.
std::optional<FalconPlace_mm> falconPlace_mm(const FalconAngles_rad& angles_rad,
                                             const FalconPlace_mm& near_mm);

/// Torques of the three motors with which the handle pushes with a force (transposed Jacobian). None outside
/// the reach, and where the legs are stretched.
std::optional<std::array<double, 3>> falconTorques_Nm(const FalconPlace_mm& place_mm,
                                                      const std::array<double, 3>& force_N);

}  // namespace detent::playback
