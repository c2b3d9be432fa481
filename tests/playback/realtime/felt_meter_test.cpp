// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/felt_meter.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/prepare/felt_level.h"
#include "playback/realtime/haptic_engine.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

std::vector<float> sine(double rate_Hz, double frequency_Hz, double amplitude, double seconds) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * rate_Hz));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<float>(
        amplitude * std::sin(2 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / rate_Hz));
  return samples;
}

double felt_dB(const HapticProgram& program, double rate_Hz, const std::vector<float>& samples) {
  FeltMeter meter;
  meter.use(program, rate_Hz);
  for (std::size_t i = 0; i < samples.size(); i += 37)
    meter.add(samples.data() + i, std::min<std::size_t>(37, samples.size() - i));
  return meter.take_dB();
}

}  // namespace

TEST_CASE("felt meter: a sine of full scale at 250 Hz has the device's level, at every rate") {
  const double rate_Hz = GENERATE(8000.0, 44100.0, 48000.0, 192000.0);
  DeviceProfile device;
  device.fullScale_dB = 38;
  const auto program = std::make_unique<HapticProgram>(prepareProgram(linearButton(), device, {})->program);
  CHECK(felt_dB(*program, rate_Hz, sine(rate_Hz, 250, 1, 0.3)) == Approx(38).margin(0.2));
  CHECK(felt_dB(*program, rate_Hz, sine(rate_Hz, 250, 0.1, 0.3)) == Approx(18).margin(0.2));
  // The strongest 10 ms hold one and a quarter periods: up to 10 lg(1 + 1 / (2 pi f T)) = 0.52 dB more than
  // their mean.
  CHECK(felt_dB(*program, rate_Hz, sine(rate_Hz, 125, 1, 0.3)) ==
        Approx(38 + pacinianWeight_dB(125) + 0.52).margin(0.1));
  CHECK(felt_dB(*program, rate_Hz, std::vector<float>(1000, 0)) == -std::numeric_limits<double>::infinity());
}

TEST_CASE("felt meter: what the device's resonances raise is felt, and a reading is taken once") {
  DeviceProfile device;
  device.resonances = {{250, 8, 12}};
  const auto program = std::make_unique<HapticProgram>(prepareProgram(linearButton(), device, {})->program);
  FeltMeter meter;
  meter.use(*program, 48000);
  const std::vector<float> samples = sine(48000, 250, 0.25, 0.3);
  meter.add(samples.data(), samples.size());
  CHECK(meter.take_dB() == Approx(45 - 12.04 + 12).margin(0.2));
  CHECK(meter.take_dB() == -std::numeric_limits<double>::infinity());
}

TEST_CASE("felt meter: of a burst it says what is foretold of it") {
  const auto program = std::make_unique<HapticProgram>(prepareProgram(linearButton(), {}, {})->program);
  for (const Burst& burst :
       {Burst{390, 0.04, 0.8, Envelope::falling}, Burst{200, 0.03, 0.5, Envelope::rising}}) {
    const auto engine = std::make_unique<HapticEngine>(48000);
    engine->use(program.get());
    engine->trigger(480, burst);
    std::vector<float> samples(4800);
    engine->render(samples.data(), samples.size());
    CHECK(felt_dB(*program, 48000, samples) == Approx(feltLevel_dB(burst, {}, *program)).margin(1.5));
  }
}
