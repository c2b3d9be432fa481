// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/measurement/profile_file.h"
#include "playback/playback.h"

namespace detent::playback {

Result<DeviceProfile> loadDeviceProfile(const std::string& file) { return readDeviceProfile(file); }

}  // namespace detent::playback
