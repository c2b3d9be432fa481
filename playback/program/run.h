// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// detent-play: its command line, and the subcommands that it runs.

#include "playback/program/command.h"

namespace detent::playback {

/// Parses and runs the chosen subcommand; returns the exit code (0 after --help, 2 after wrong usage, which
/// is explained).
int run(int argc, char** argv, const Cancelled& cancelled);

}  // namespace detent::playback
