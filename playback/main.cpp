// SPDX-License-Identifier: GPL-3.0-or-later
// detent-play: press a button and feel it. Parses the command line, runs a subcommand, returns the exit code.

#include <cstdio>
#include <exception>

#include "playback/program/interruption.h"
#include "playback/program/run.h"

int main(int argc, char** argv) {
  try {
    const detent::playback::Interruption interruption;
    return detent::playback::run(argc, argv, [&] { return interruption.requested(); });
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "detent-play: internal fault: %s. Please report it with the input file.\n",
                 fault.what());
    return 1;
  }
}
