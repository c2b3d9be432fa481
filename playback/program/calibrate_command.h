// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play calibrate`: calibrates a sensor with known weights and stores the result in the profile.
void addCalibrateCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
