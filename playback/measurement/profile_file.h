// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Device profiles as text files (docs/reference/device-profile.md): one "key = value" per line, so that a
// person can read, edit and compare them.

#include <filesystem>
#include <string>

#include "model/named_values.h"
#include "model/result.h"
#include "playback/prepare/device_profile.h"

namespace detent::playback {

inline constexpr auto sensorCircuits = named<SensorCircuit>({{"newtons", SensorCircuit::newtons},
                                                             {"linear", SensorCircuit::linear},
                                                             {"divider", SensorCircuit::divider}});

inline constexpr int deviceProfileVersion = 1;

/// Failure names the line. Unknown keys and newer versions are refused, so that a typing error is not
/// silently ignored.
Result<DeviceProfile> parseDeviceProfile(const std::string& text, const std::string& name);
Result<DeviceProfile> readDeviceProfile(const std::filesystem::path& file);

/// Numbers survive a round trip bit for bit.
std::string toText(const DeviceProfile& profile);
/// Written beside the target and renamed.
Result<Done> writeDeviceProfile(const DeviceProfile& profile, const std::filesystem::path& file);

}  // namespace detent::playback
