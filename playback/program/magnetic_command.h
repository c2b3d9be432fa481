// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "playback/program/command.h"

namespace detent::playback {

void addMagneticCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
