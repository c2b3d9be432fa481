// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// From a button, a device and settings to the program that the callback plays. Only parts that the button has
// are prepared: no jump entry for a linear button, no second state for a momentary one, no equalizer for a
// flat device.

#include <string>
#include <vector>

#include "model/button.h"
#include "model/message.h"
#include "model/result.h"
#include "playback/prepare/device_profile.h"
#include "playback/prepare/playback_settings.h"
#include "playback/realtime/haptic_program.h"

namespace detent::playback {

/// Requests that a program cannot fulfil for this button or device.
enum class PrepareWarningCode : std::uint8_t {
  hysteresisReduced,  ///< strongest force, requested hysteresis
  noResonance,        ///< press and release frequency that are used instead, Hz
  slopesLeftOut,      ///< number that a program holds
  jumpsLeftOut,       ///< number found, number kept, messages with the places of those left out
  jumpClipped,        ///< place, factor of full scale that it would need
  /// dB by which the paper's levels put jumps below slope or bottom-out, messages with the places of these
  /// jumps
  clickDrowned,
  equalizerSpared  ///< messages of the bands' frequencies
};

/// A warning: the code is for programs, the message for people (model/message.h).
struct PrepareWarning {
  PrepareWarningCode code;
  Message message;
};

/// Name for scripts: "jumps-left-out".
const char* nameOf(PrepareWarningCode code);

/// Summary of the preparation, for a one-line report and for doubts.
struct PrepareSummary {
  std::size_t grains = 0;  ///< grain positions of the first state's press stroke
  std::size_t pressJumps = 0, releaseJumps = 0, bottomOuts = 0;  ///< numbers over all states
  std::size_t tablePoints = 0;
  double tableError_N = 0;  ///< largest distance of a table from its curve
  std::vector<PrepareWarning> warnings;

  /// "54 grains, 1 press jump, 1 release jump, bottom-out; table 212 points, error 0.0001 N".
  std::string line() const;
};

struct PreparedProgram {
  HapticProgram program;
  PrepareSummary summary;
};

/// Failure wrongUsage names the setting or profile value that is outside its range. Any thread; allocates.
Result<PreparedProgram> prepareProgram(const Button& button, const DeviceProfile& profile,
                                       const PlaybackSettings& settings);

/// The range checks of prepareProgram alone.
Result<Done> checkSettings(const PlaybackSettings& settings);
Result<Done> checkProfile(const DeviceProfile& profile);

}  // namespace detent::playback
