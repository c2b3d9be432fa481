// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Options of force devices that several subcommands share.

#include <optional>
#include <string>

#include "model/result.h"
#include "playback/force_feedback.h"
#include "playback/program/command.h"

namespace detent::playback {

inline constexpr const char* forceDeviceWords = "sim[:falcon|:rig]|serial:PORT|odrive:PORT|falcon[:N]";

struct RealDeviceOptions {
  double step_mm = 0;               ///< 0: the preset's
  std::optional<double> largest_N;  ///< none: that of the preset; 0 is a valid limit, which no device has
  unsigned baud = 0, axis = 0;      ///< baud 0: the device's own
  double mmPerTurn = 60;
  std::string firmwareFile;  ///< firmware file of a Falcon

  void applyTo(ForceDeviceChoice& device) const;
};

/// All options except the serial port's speed.
void addForceDeviceOptions(CLI::App& app, RealDeviceOptions& options, const char* largestForce);
void addRealDeviceOptions(CLI::App& app, RealDeviceOptions& options, const char* largestForce);
inline constexpr const char* realDeviceGroup = "Real devices (docs/guide/force-feedback.md)";

/// Failure: --fast was given for a device with hardware.
Failure fastNeedsSimulation();

}  // namespace detent::playback
