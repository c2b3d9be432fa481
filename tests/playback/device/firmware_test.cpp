// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the Arduino sketch of samples/firmware on a clock of its own and reads what it sends.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/device/sensor_line.h"
#include "tests/playback/device/sketch_on_host.h"

namespace firmware {

std::uint32_t time_us = 4294900000U;  // wraps during the test

std::uint32_t micros() { return time_us; }
int analogRead(std::uint8_t) { return static_cast<int>(time_us / 1000 % 1024); }

}  // namespace firmware

TEST_CASE("firmware: a thousand time-stamped readings a second, each with a good checksum") {
  firmware::setup();
  for (int i = 0; i < 200000; ++i, firmware::time_us += 10) firmware::loop();
  detent::playback::LineAssembler assembler;
  std::vector<detent::playback::SensorLine> lines;
  assembler.feed(firmware::sent, [&](const auto& line) { lines.push_back(line); });
  CHECK(lines.size() == 2000);
  CHECK(assembler.counts().malformed == 0);
  CHECK(assembler.counts().badChecksums == 0);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    CHECK(lines[i].timed);
    CHECK(lines[i].time_us - lines[i - 1].time_us == 1000);
  }
  // A stall of a second does not send a thousand old readings.
  firmware::sent.clear();
  firmware::time_us += 1000000;
  for (int i = 0; i < 1000; ++i, firmware::time_us += 10) firmware::loop();
  CHECK(std::count(firmware::sent.begin(), firmware::sent.end(), '\n') < 15);
  // Who opens the port long after the start is told who is there.
  CHECK(assembler.greeting() == "detent-force 1 fsr400 divider 1023");
  detent::playback::LineAssembler late;
  firmware::sent.clear();
  for (int i = 0; i < 100; ++i, firmware::time_us += 10) firmware::loop();
  firmware::incoming = "?\n";
  for (int i = 0; i < 200; ++i, firmware::time_us += 10) firmware::loop();
  late.feed(firmware::sent, [](const auto&) {});
  CHECK(late.greeting() == "detent-force 1 fsr400 divider 1023");
}
