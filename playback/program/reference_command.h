// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play reference: describes a signal made by another program, or writes it as sound.

#include "playback/program/command.h"

namespace detent::playback {

void addReferenceCommand(CLI::App& program, Action& chosen);

}  // namespace detent::playback
