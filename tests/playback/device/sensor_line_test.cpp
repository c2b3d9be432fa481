// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/sensor_line.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/device/signal_message.h"

using namespace detent::playback;

TEST_CASE("sensor line: counts, newtons, time stamps, checksums") {
  SensorLine line;
  CHECK(parseSensorLine("512", line) == LineVerdict::reading);
  CHECK(line.value == 512);
  CHECK_FALSE(line.newtons);
  CHECK_FALSE(line.timed);
  CHECK(parseSensorLine("123456,1.25N\r", line) == LineVerdict::reading);
  CHECK(line.newtons);
  CHECK(line.time_us == 123456);
  CHECK(line.value == 1.25);
  const std::string text = "4294967295,3";
  char sum[8];
  std::snprintf(sum, sizeof sum, "*%02X", lineChecksum(text));
  CHECK(parseSensorLine(text + sum, line) == LineVerdict::reading);
  CHECK(parseSensorLine(text + "*00", line) == LineVerdict::badChecksum);
  CHECK(parseSensorLine("nan", line) == LineVerdict::reading);  // the conditioner rejects and counts it
  CHECK(std::isnan(line.value));
  CHECK(parseSensorLine("# detent-force 1", line) == LineVerdict::comment);
  CHECK(parseSensorLine("", line) == LineVerdict::comment);
  for (const char* bad :
       {"abc", "1,2,3", ",5", "5,", "1*", "1*G0", "*00", "-1,5", "99999999999,5", "1 2", "N", "5NN"}) {
    INFO(bad);
    CHECK(parseSensorLine(bad, line) != LineVerdict::reading);
  }
}

TEST_CASE("line assembler: any cut of the stream gives the same readings; floods stay bounded") {
  std::string stream = "17\n";  // half a line after plugging in: not believed
  for (int i = 0; i < 200; ++i) stream += std::to_string(i * 1000) + "," + std::to_string(i) + "\n";
  stream += std::string(5000, 'x') + "\n" + "rubbish\n" + "201000,201\n";
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    LineAssembler assembler;
    std::vector<double> values;
    for (std::size_t at = 0; at < stream.size();) {
      const std::size_t n = std::min<std::size_t>(1 + random() % 40, stream.size() - at);
      assembler.feed(std::string_view(stream).substr(at, n),
                     [&](const SensorLine& l) { values.push_back(l.value); });
      at += n;
    }
    REQUIRE(values.size() == 201);
    CHECK(values[7] == 7);
    CHECK(values.back() == 201);
    CHECK(assembler.counts().overlong == 1);
    CHECK(assembler.counts().malformed == 1);
  }
}

TEST_CASE("clock aligner: bus delay is taken out, wrap and drift are followed") {
  ClockAligner aligner;
  std::mt19937 random(9);
  std::uint32_t device = 4294000000U;  // wraps soon
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double true_s = 1000 + i * 1e-3 * (1 + 100e-6);  // the sensor's clock is 100 ppm slow
    const double arrival_s =
        true_s + 0.0002 + (i % 5 == 0 ? 0 : 0.004 * (static_cast<double>(random() % 1000) / 1000));
    const double estimate = aligner.hostTime_s(device, arrival_s);
    CHECK(estimate <= arrival_s + 1e-5);
    if (i > 100) worst = std::max(worst, std::fabs(estimate - true_s - 0.0002));
    device += 1000;
  }
  CHECK(worst < 0.0002);
  CHECK(aligner.hostTime_s(5, 5000) == 5000);  // restarted sensor
}

TEST_CASE("signal messages: FUDI in and out, limits, rubbish") {
  std::vector<SignalMessage> got;
  SignalCounts counts;
  const auto parse = [&](std::string_view text) {
    got.clear();
    parseFudi(text, counts, [&](const SignalMessage& m) { got.push_back(m); });
  };
  parse("jump 390 20 0.8;\nbottom 200 30 0.7;grain;grain 150 20 0.5;force 1.5;displacement 0.2;gain 0.5;");
  REQUIRE(got.size() == 7);
  CHECK(got[0].burst.frequency_Hz == 390);
  CHECK(got[0].burst.duration_s == 0.02);
  CHECK(got[1].burst.envelope == Envelope::rising);
  CHECK(got[2].bare);
  CHECK(got[6].value == 0.5);
  for (const char* bad : {"jump;", "jump 390 20;", "jump 390 20 2;", "jump nan 20 0.5;", "jump 390 20 0.5 1;",
                          "jump 390 5000 0.5;", "force inf;", "gain -1;", "gain 2;", "explode 1;",
                          "jump 1e999 1 1;", "\xff\xfe;"}) {
    const auto before = counts.malformed;
    parse(bad);
    INFO(bad);
    CHECK(got.empty());
    CHECK(counts.malformed == before + 1);
  }
  SignalMessage m;
  m.kind = SignalKind::jump;
  m.burst = {390, 0.0335, 0.5};
  CHECK(toFudi(m) == "jump 390 33.5 0.5;\n");
  parse(toFudi(m));
  REQUIRE(got.size() == 1);
  CHECK(got[0].burst.duration_s == 0.0335);
  // Keys of controllers send a number along: 1 where they are pressed, 0 where they are let go.
  parse("grain 1;grain 0;hold 1;hold 0;hold;grain 127;");
  REQUIRE(got.size() == 4);
  CHECK((got[0].kind == SignalKind::grain && got[0].bare));
  CHECK((got[1].kind == SignalKind::hold && got[2].kind == SignalKind::hold));
  CHECK(got[3].bare);
  const double arguments[3] = {390, 20, 0.5};
  CHECK(fromOsc("/detent/jump", arguments, 3, m));
  CHECK_FALSE(fromOsc("/detent/jump", arguments, 2, m));
  CHECK_FALSE(fromOsc("/other/jump", arguments, 3, m));
}

TEST_CASE("clock: one stamp far ahead costs one reading, not minutes") {
  ClockAligner aligner;
  double worst_s = 0;
  for (int i = 0; i < 4000; ++i) {
    const double arrival_s = 10 + i / 1000.0 + 0.002;
    std::uint32_t stamp_us = static_cast<std::uint32_t>(i * 1000);
    if (i == 1000) stamp_us += 400000;
    const double host_s = aligner.hostTime_s(stamp_us, arrival_s);
    worst_s = std::max(worst_s, std::fabs(host_s - arrival_s));
  }
  CHECK(worst_s < 0.005);
  CHECK(aligner.wrongStamps() == 1);
}

TEST_CASE("assembler: the firmware's greeting is kept") {
  LineAssembler assembler;
  assembler.feed("# detent-force 1 fsr400 divider 1023\r\n1,2*1D\n", [](const SensorLine&) {});
  CHECK(assembler.greeting() == "detent-force 1 fsr400 divider 1023");
}
