// SPDX-License-Identifier: GPL-3.0-or-later
// detent-play: press a button and feel it. Parses, runs, sets the exit code.

#include <csignal>
#include <cstdio>
#include <exception>

#include "playback/program/run.h"

namespace {

volatile std::sig_atomic_t interrupted = 0;

// The second request ends the program at once.
void onInterrupt(int number) {
  if (interrupted != 0) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
  interrupted = 1;
  std::signal(number, onInterrupt);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  try {
    return detent::playback::run(argc, argv, [] { return interrupted != 0; });
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "detent-play: internal fault: %s. Please report it with the input file.\n",
                 fault.what());
    return 1;
  }
}
