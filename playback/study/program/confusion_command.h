// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play confusion: will people tell these buttons apart?

#include "playback/program/command.h"

namespace detent::playback {

void addConfusionCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
