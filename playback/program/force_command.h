// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

/// `detent-play force`: a button as force on a device, with log and statistics
/// (docs/guide/force-feedback.md).
void addForceCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
