// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play: its command line, and what it runs.

#include "playback/program/command.h"

namespace detent::playback {

/// Parses, runs what was chosen; exit code (0 after --help, 2 after a wrong use that was explained).
int run(int argc, char** argv, const Cancelled& cancelled);

}  // namespace detent::playback
