// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play between: the button between two others, by feel.

#include "playback/program/command.h"

namespace detent::playback {

void addBetweenCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
