// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play identify`: k(x), b(x) and mass from a recorded press, with standard errors.
void addIdentifyCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
