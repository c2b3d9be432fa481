// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/playback.h"
#include "playback/study/profile_file.h"

namespace detent::playback {

Result<DeviceProfile> loadDeviceProfile(const std::string& file) { return readDeviceProfile(file); }

}  // namespace detent::playback
