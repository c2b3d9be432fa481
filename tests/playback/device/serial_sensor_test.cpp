// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/device/serial_sensor.h"

#include <cmath>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/device/press_source.h"
#include "playback/device/steady_clock.h"
#include "tests/playback/device/pty_sensor.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

struct Collected {
  std::mutex mutex;
  std::vector<SensorReading> readings;
  SerialSensor::Receiver receiver() {
    return [this](const SensorReading& r) {
      const std::lock_guard lock(mutex);
      readings.push_back(r);
    };
  }
  std::vector<SensorReading> take() {
    const std::lock_guard lock(mutex);
    return readings;
  }
};

template <class Condition>
bool within(double seconds, Condition condition) {
  for (const double end = now_s() + seconds; now_s() < end; sleepUntil(now_s() + 0.01)) {
    if (condition()) return true;
  }
  return condition();
}

}  // namespace

TEST_CASE("serial sensor: a pty at 425 Hz and 1 kHz loses nothing") {
  for (const double rate : {425.0, 1000.0}) {
    PtySensor pty;
    if (!pty.ready()) {
      std::cout << "SKIPPED serial sensor: no pseudo-terminal here\n";
      return;
    }
    Collected collected;
    SerialSettings settings;
    settings.port = pty.port();
    auto sensor = SerialSensor::open(settings, collected.receiver());
    REQUIRE(sensor);
    const int count = static_cast<int>(rate);
    double next_s = now_s();
    for (int i = 0; i <= count; ++i) {
      sleepUntil(next_s += 1 / rate);
      char line[40];
      std::snprintf(line, sizeof line, "%u,%.3fN\n", static_cast<unsigned>(i * 1e6 / rate), 1 + 0.001 * i);
      REQUIRE(pty.send(line));
    }
    CHECK(within(1, [&] { return collected.take().size() > static_cast<std::size_t>(count); }));
    const auto readings = collected.take();
    CHECK(readings.size() == static_cast<std::size_t>(count + 1));
    CHECK(readings.front().resumed);
    for (std::size_t i = 1; i < readings.size(); ++i) {
      CHECK_FALSE(readings[i].resumed);
      CHECK(readings[i].time_s > readings[i - 1].time_s);
      CHECK(readings[i].force_N == Approx(1 + 0.001 * static_cast<double>(i)));
    }
    CHECK(within(1, [&] { return (*sensor)->health().readings.accepted == readings.size(); }));
    const SensorHealth health = (*sensor)->health();
    CHECK(health.state == SensorState::running);
  }
}

TEST_CASE("serial sensor: rubbish is counted, silence seen, unplugging survived") {
  PtySensor pty;
  if (!pty.ready()) return;
  Collected collected;
  SerialSettings settings;
  settings.port = pty.port();
  settings.lowestReopen_s = 0.05;
  settings.calibration.circuit = SensorCircuit::linear;
  settings.calibration.fullScale_counts = 1000;
  settings.calibration.coefficients = {0, 12, 0, 0};
  auto sensor = SerialSensor::open(settings, collected.receiver());
  REQUIRE(sensor);
  pty.send("0,500\n1000,nan\n2000,rubbish\n3000,inf\n4000,500\n5000,500*00\n");
  CHECK(within(1, [&] { return collected.take().size() == 2; }));
  CHECK(collected.take()[0].force_N == Approx(6));
  CHECK(within(1, [&] { return (*sensor)->health().readings.accepted == 2; }));
  const SensorHealth health = (*sensor)->health();
  CHECK(health.readings.notFinite == 2);
  CHECK(health.lines.malformed == 1);
  CHECK(health.lines.badChecksums == 1);
  CHECK(within(2, [&] { return (*sensor)->health().state == SensorState::silent; }));

  pty.unplug();
  CHECK(within(2, [&] { return (*sensor)->health().state == SensorState::unplugged; }));
  pty.plugIn();
  REQUIRE(pty.ready());
  CHECK(within(2, [&] { return (*sensor)->health().reconnects == 1; }));
  pty.send("0,100\n1000,100\n");
  CHECK(within(1, [&] { return collected.take().size() == 4; }));
  CHECK(collected.take()[2].resumed);
  CHECK_FALSE(collected.take()[3].resumed);
}

TEST_CASE("serial sensor: a flood of bytes neither blocks nor grows") {
  PtySensor pty;
  if (!pty.ready()) return;
  Collected collected;
  SerialSettings settings;
  settings.port = pty.port();
  auto sensor = SerialSensor::open(settings, collected.receiver());
  REQUIRE(sensor);
  const std::string noise(1024, 'x');
  const double end_s = now_s() + 0.3;
  std::size_t sent = 0;
  while (now_s() < end_s) sent += pty.send(noise) ? noise.size() : 0;
  CHECK(within(1, [&] { return pty.send("\n1,1N\n"); }));
  CHECK(within(1, [&] { return collected.take().size() == 1; }));
  CHECK((*sensor)->health().lines.overlong == 1);
  CHECK((*sensor)->health().lines.bytes >= sent);
}

TEST_CASE("serial sensor: a port that is not there is device trouble with its name") {
  SerialSettings settings;
  settings.port = "/dev/detent-no-such-port";
  auto sensor = SerialSensor::open(settings, [](const SensorReading&) {});
  REQUIRE_FALSE(sensor);
  CHECK(english(sensor.failure().subject.name) == settings.port);
}

TEST_CASE("virtual finger: reaches its force, holds, lets go, and rests silently") {
  Collected collected;
  FingerProfile profile;
  {
    VirtualFinger finger(profile, collected.receiver());
    finger.tap(0.15);
    CHECK(within(1, [&] { return !finger.isDown(); }));
    sleepUntil(now_s() + 0.2);
    const std::size_t before = collected.take().size();
    sleepUntil(now_s() + 0.1);
    CHECK(collected.take().size() == before);
  }
  const auto readings = collected.take();
  double peak = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    peak = std::max(peak, readings[i].force_N);
    CHECK(readings[i].time_s > readings[i - 1].time_s);
  }
  CHECK(peak == Approx(profile.peak_N).epsilon(0.02));
  CHECK(readings.back().force_N == 0);
  CHECK(readings.size() > 100);
  CHECK(pressedForce(profile, 0, 0) == 0);
  CHECK(pressedForce(profile, 0, profile.press_s) == Approx(profile.peak_N));
  CHECK(releasedForce(profile, 1, profile.release_s) == 0);
}
