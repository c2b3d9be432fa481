// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play devices`: the sound devices of this machine.
void addDevicesCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
