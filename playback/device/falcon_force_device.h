// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A Novint Falcon: pressing goes away from the person, along z; sideways is x and y, held on the axis by the guide. It has never
// touched hardware (docs/guide/force-feedback.md).

#include <cstdint>
#include <memory>
#include <vector>

#include "model/result.h"
#include "playback/device/force_device.h"

namespace detent::playback {

struct FalconSettings {
  unsigned number = 0;                 ///< of several
  std::vector<std::uint8_t> firmware;  ///< empty: the device has been given one since it was switched on
  double period_s = 0.001;
};

/// Where a button's rest lies, before the middle of the base, mm.
inline constexpr double falconRest_mm = 140;

/// Opens it, gives it the firmware where it has none (some seconds; it may take several tries, counted). Trouble: not connected, no
/// right to it, no firmware, none taken. Until the person has moved the handle all the way out and in, it is `homing`.
Result<std::unique_ptr<ForceDevice>> openFalcon(const FalconSettings& settings);

}  // namespace detent::playback
