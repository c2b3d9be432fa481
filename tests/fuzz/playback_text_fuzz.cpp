// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes, as if they were a press trace, a device profile or a list of weights. What is accepted must be
// usable.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "playback/measurement/calibrate.h"
#include "playback/measurement/profile_file.h"
#include "playback/offline/press_files.h"

using namespace detent::playback;

namespace {
void demand(bool condition) {
  if (!condition) std::abort();
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 3) {
    case 0: {
      const auto trace = parsePressTrace(text, "fuzz");
      if (trace) demand(!trace->readings.empty());
      break;
    }
    case 1: {
      const auto profile = parseDeviceProfile(text, "fuzz");
      if (!profile) break;
      const auto again = parseDeviceProfile(toText(*profile), "again");
      demand(again.ok() && toText(*again) == toText(*profile));
      break;
    }
    default: {
      const auto weights = parseWeights(text, "fuzz");
      if (!weights) break;
      const auto calibration = calibrate(*weights, {});
      if (calibration) demand(std::isfinite(calibration->residual_N));
    }
  }
  return 0;
}
