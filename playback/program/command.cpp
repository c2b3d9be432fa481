// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/command.h"

#include <cstdio>

namespace detent::playback {

int fail(const Failure& failure) {
  std::fprintf(stderr, "detent-play: %s\n", failure.sentence().c_str());
  return failure.exitCode();
}

}  // namespace detent::playback
