// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs that say nothing about the program, in tests with Catch.

#include <iostream>
#include <string>

#include <catch2/catch.hpp>

#include "tests/playback/plant/pty_device.h"

namespace detent::test {

/// True if a run says anything about the program; otherwise prints that the scene was skipped. A force above
/// the largest fails here. Only on Catch's thread.
inline bool judged(const Witness& device, const std::string& scene) {
  if (device.tooStrong)
    std::cout << "FORCE ABOVE THE LIMIT in " << scene << std::endl;  // tests/run.sh does not repeat that
  CHECK_FALSE(device.tooStrong);
  if (device.judged) return true;
  std::cout << "SKIPPED " << scene << ": the emulated device was late in each run" << std::endl;
  WARN("SKIPPED: the emulated device was late in each run");
  return false;
}

}  // namespace detent::test
