// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Options that several subcommands share, so that they are worded once.

#include <optional>
#include <string>

#include "playback/playback.h"
#include "playback/program/command.h"

namespace detent::playback {

/// "How it feels": every setting of the paper, and the device it is prepared for.
struct FeelOptions {
  PlaybackSettings settings = usualSettings();
  std::string profileFile;  ///< empty: a perfect device
};
void addFeelOptions(CLI::App& app, FeelOptions& options);

/// --placement alone, for subcommands without the other settings of the feel.
CLI::Option* addPlacementOption(CLI::App& app, EventPlacement& placement);

/// The sound output.
void addDeviceOptions(CLI::App& app, PlayerSettings& options);

/// The serial force sensor.
struct SensorOptions {
  std::string port;  ///< empty: none
  unsigned baud = 230400;
};
void addSensorOptions(CLI::App& app, SensorOptions& options);

/// The profile in `file`, or an empty one if no file is named.
Result<DeviceProfile> profileOf(const std::string& file);

/// The profile to which a measurement is added: an existing one is extended; an unreadable one is not
/// overwritten.
Result<DeviceProfile> profileToExtend(const std::string& file);

/// Prints to stderr which of several graphs a press uses, by its speed.
void tellSpeed(const Button& button, std::optional<double> speed_mm_per_s);

}  // namespace detent::playback
