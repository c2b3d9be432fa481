// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The studies' subcommands of detent-play: confusion and study; none in a build without studies.

#include "playback/program/command.h"

namespace detent::playback {

void addStudyCommands(CLI::App& program, Action& chosen);

}  // namespace detent::playback
