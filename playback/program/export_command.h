// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play export: a press of a button in the formats of other devices.

#include "playback/program/command.h"

namespace detent::playback {

void addExportCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
