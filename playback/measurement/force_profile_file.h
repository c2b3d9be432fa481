// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Measured values of a force device, as a text file like the profile of a vibrating device
// (docs/reference/device-profile.md).

#include <string>

#include "model/result.h"
#include "playback/prepare/force_device_profile.h"

namespace detent::playback {

inline constexpr int forceDeviceFileVersion = 1;

/// Values with their standard errors, in the units of ForceDeviceProfile.
struct ForceDeviceMeasurement {
  struct Value {
    double value = 0, sigma = 0;
  };
  std::string name;
  Value mass_kg, friction_N, damping_Ns_per_mm, delay_s, lag_s;
  Value late_s;  ///< delay and lag together
  /// rate of the loop that measured it: if a host runs the law, the delay contains one period
  double rate_Hz = 0;
  double step_mm = 0;  ///< step of the encoder; 0: not stated
};

/// A profile with the device's own mass, friction, damping, delay, lag and encoder step (if it is stated). If
/// a host runs the law (`hosted`) at a slower `rate_Hz` than the measurement had, the delay increases by the
/// difference of the periods.
ForceDeviceProfile measuredProfile(ForceDeviceProfile profile, const ForceDeviceMeasurement& measured,
                                   double rate_Hz, bool hosted);

/// Failure names the line. Unknown keys and newer versions are refused.
Result<ForceDeviceMeasurement> parseForceDevice(const std::string& text, const std::string& name);
Result<ForceDeviceMeasurement> readForceDevice(const std::string& file);
/// Numbers survive a round trip bit for bit.
std::string toText(const ForceDeviceMeasurement& device);
/// Written beside the target and renamed.
Result<Done> writeForceDevice(const ForceDeviceMeasurement& device, const std::string& file);

}  // namespace detent::playback
