// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes, as if they were a signal of another program (AHAP, .haptic, HJIF, WAV) or the readings of a
// magnetic switch. What is taken sounds within full scale; what is not has a reason and a remedy.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include "playback/interchange/reference_signal.h"
#include "playback/magnetic/magnetic_sensor.h"

using namespace detent;
using namespace detent::playback;

namespace {

void demand(bool condition) {
  if (!condition) std::abort();
}

void demandReason(const Failure& failure) {
  demand(!failure.sentence().empty());
  demand(!failure.remedies.empty());
}

void readAsReference(const std::string& file) {
  const auto signal = readReference(file);
  if (!signal) return demandReason(signal.failure());
  demand(!signal->samples.empty());
  for (const float sample : signal->samples) demand(std::fabs(sample) <= 1);  // false for a NaN
}

void readAsSensor(const std::string& file) {
  const auto sensor = MagneticSensor::fromCsv(file, 1);
  if (!sensor) return demandReason(sensor.failure());
  const auto& pairs = sensor->pairs();
  demand(pairs.size() >= 2);
  for (const SensorPair& pair : pairs) demand(std::isfinite(sensor->reading(pair.displacement_mm)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int memory = memfd_create("fuzz", 0);
  demand(memory >= 0 && write(memory, data, size) == static_cast<ssize_t>(size));
  const std::string file = "/proc/self/fd/" + std::to_string(memory);
  readAsReference(file);
  readAsSensor(file);
  close(memory);
  return 0;
}
