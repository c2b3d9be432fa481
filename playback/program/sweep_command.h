// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play sweep`: measures a device's frequency response and writes its profile.
void addSweepCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
