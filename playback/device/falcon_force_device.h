// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A Novint Falcon. Pressing moves the handle away from the person, along z; x and y are sideways, and the
// guide keeps the handle on the axis. Not yet tested with hardware (docs/guide/force-feedback.md).

#include <cstdint>
#include <memory>
#include <vector>

#include "model/result.h"
#include "playback/device/force_device.h"

namespace detent::playback {

struct FalconSettings {
  unsigned number = 0;  ///< index among several connected Falcons
  /// empty: the device has received its firmware since it was switched on
  std::vector<std::uint8_t> firmware;
  double period_s = 0.001;
};

/// Position of a button's rest, mm in front of the middle of the base.
inline constexpr double falconRest_mm = 140;

/// Opens the device and uploads the firmware if it has none, which takes some seconds and may need several
/// tries (counted). Failure deviceTrouble: not connected, no permission, no firmware, or upload failed. The
/// state is `homing` until the person has moved the handle all the way out and in.
Result<std::unique_ptr<ForceDevice>> openFalcon(const FalconSettings& settings);

}  // namespace detent::playback
