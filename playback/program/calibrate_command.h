// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play calibrate`: from known weights to a sensor's calibration in the profile.
void addCalibrateCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
