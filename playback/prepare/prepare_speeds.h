// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// For a button with graphs at several speeds: one playable program for each of a series of speeds.

#include <vector>

#include "playback/prepare/prepare_program.h"
#include "playback/realtime/live_program.h"

namespace detent::playback {

/// Programs by increasing speed: the stated speeds, each exactly the button at that speed
/// (model/speed_family.h), and evenly spaced ones between. There are so many that no force changes by more
/// than `finestSpeedStep` of the button's strongest from one to the next, but at most `mostSpeedSteps` - 1
/// between two stated speeds. Empty for a button with one graph per state. Failures: as prepareProgram. Any
/// thread; allocates.
Result<std::vector<SpeedProgram>> prepareSpeeds(const Button& button, const DeviceProfile& profile,
                                                const PlaybackSettings& settings);

inline constexpr double finestSpeedStep = 0.02;  // a third of the smallest difference that a finger feels
inline constexpr int mostSpeedSteps = 8;         // most steps from one stated speed to the next

/// The program under a finger: `front`, prepared from the same three, with its speeds.
Result<LiveProgram> prepareLive(const PreparedProgram& front, const Button& button,
                                const DeviceProfile& profile, const PlaybackSettings& settings);

}  // namespace detent::playback
