// SPDX-License-Identifier: GPL-3.0-or-later
// The front door as the editor uses it, without a device.

#include "playback/playback.h"

#include <chrono>
#include <cmath>
#include <memory>

#include <catch2/catch.hpp>

#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

TEST_CASE("door: a standard press feels everything the button has, within 20 ms of work") {
  for (const Button& button : {linearButton(), tactileButton(), twoLevelButton(), lockingButton()}) {
    const auto program = std::make_unique<HapticProgram>(programOf(button));
    double fastest_s = 1;
    for (int i = 0; i < 5; ++i) {
      const auto began = std::chrono::steady_clock::now();
      const Result<RenderedPress> rendered = renderStandardPress(*program);
      fastest_s = std::min(fastest_s,
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
      REQUIRE(rendered);
      CHECK(rendered->summary.counts.pressJumps == program->states[0].press.jumpCount);
      CHECK(rendered->summary.counts.bottomOuts == 1);
      CHECK(rendered->summary.counts.grains > 10);
      CHECK(rendered->summary.sensor.accepted > 100);
      CHECK(rendered->samples.size() > 10000);
      CHECK(rendered->summary.peak <= 1);
    }
    CHECK(fastest_s < 0.020);
  }
}

TEST_CASE("door: a standard press rises, holds and ends at nothing") {
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const PressTrace trace = standardPress(*program);
  double peak = 0;
  for (const PressReading& r : trace.readings) peak = std::max(peak, r.value);
  CHECK(peak == Approx(1.25 * 0.8).epsilon(0.02));
  CHECK(trace.readings.front().value == 0);
  CHECK(trace.readings.back().value == 0);
  StandardPress impossible;
  impossible.press_s = 0;
  CHECK(renderStandardPress(*program, 48000, impossible).failure().exitCode() == 2);
  impossible.press_s = std::nan("");
  CHECK_FALSE(renderStandardPress(*program, 48000, impossible));
  CHECK_FALSE(renderStandardPress(*program, 1000));
  CHECK(loadDeviceProfile("no-such.device").failure().exitCode() == 3);
}
