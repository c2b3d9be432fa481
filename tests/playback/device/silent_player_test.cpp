// SPDX-License-Identifier: GPL-3.0-or-later
// A player without a sound device: the finger is followed all the same.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>

#include <catch2/catch.hpp>

#include "model/speed_family.h"
#include "playback/device/steady_clock.h"
#include "playback/playback.h"
#include "tests/playback/device/pty_sensor.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

std::unique_ptr<LivePlayer> silent(const Button& button) {
  const auto program = std::make_unique<HapticProgram>(programOf(button));
  Result<std::unique_ptr<LivePlayer>> player = LivePlayer::startSilent(*program);
  REQUIRE(player);
  return std::move(*player);
}

template <class Condition>
bool within(double seconds, Condition condition) {
  for (const double end = now_s() + seconds; now_s() < end; sleepUntil(now_s() + 0.002)) {
    if (condition()) return true;
  }
  return condition();
}

/// Threads of this program.
std::ptrdiff_t threads() { return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}); }

void pressTo(LivePlayer& player, double peak_N) {
  for (int i = 0; i <= 40; ++i) {
    player.pushForce(peak_N * (i <= 20 ? i : 40 - i) / 20.0);
    sleepUntil(now_s() + 0.001);
  }
}

std::vector<EventKind> kindsOf(const std::vector<EngineEvent>& events) {
  std::vector<EventKind> kinds;
  for (const EngineEvent& e : events)
    if (e.kind != EventKind::grain) kinds.push_back(e.kind);
  return kinds;
}

}  // namespace

TEST_CASE("silent: a tap is followed through the whole travel and back, with everything met on the way") {
  const auto player = silent(tactileButton());
  CHECK_FALSE(player->status().sounding);
  CHECK(player->status().sampleRate_Hz == 0);
  player->fingerTap(1.5, 0.12);
  double deepest_mm = 0;
  CHECK(within(3, [&] {
    const PlayerStatus s = player->status();
    deepest_mm = std::max(deepest_mm, s.displacement_mm);
    return s.counts.releaseJumps == 1 && s.displacement_mm == 0;
  }));
  CHECK(deepest_mm == Approx(4));
  const PlayerStatus s = player->status();
  CHECK(s.counts.pressJumps == 1);
  CHECK(s.counts.bottomOuts == 1);
  CHECK(s.counts.grains > 80);
  const std::vector<EngineEvent> events = player->takeEvents();
  const std::vector<EventKind> kinds = kindsOf(events);
  REQUIRE(kinds.size() >= 3);
  CHECK(kinds.front() == EventKind::pressJump);
  CHECK(std::count(kinds.begin(), kinds.end(), EventKind::bottomOut) == 1);
  CHECK(std::is_sorted(events.begin(), events.end(),
                       [](const EngineEvent& a, const EngineEvent& b) { return a.frame < b.frame; }));
  CHECK(player->takeEvents().empty());
}

TEST_CASE("silent: a self-locking button changes its state at each press") {
  const auto player = silent(lockingButton());
  CHECK(player->status().state == 0);
  pressTo(*player, 2);
  CHECK(player->status().state == 1);
  pressTo(*player, 2);
  CHECK(player->status().state == 0);
}

TEST_CASE("silent: another button under the finger takes the finger over without an event") {
  const auto player = silent(tactileButton());
  for (int i = 0; i <= 20; ++i) {
    player->pushForce(0.03 * i);
    sleepUntil(now_s() + 0.001);
  }
  player->takeEvents();
  const auto linear = std::make_unique<HapticProgram>(programOf(linearButton()));
  player->setProgram(*linear);
  CHECK(player->takeEvents().empty());
  CHECK(player->status().displacement_mm == Approx(2 + 0.2 / 0.15).margin(0.01));  // 0.6 N on A's line
}

TEST_CASE(
    "silent: another button under a finger that is held by its displacement leaves it there, and no press is "
    "counted") {
  const auto player = silent(linearButton());
  auto moveTo = [&, at_mm = 0.0](double to_mm) mutable {
    for (const double from_mm = at_mm; at_mm != to_mm;) {
      at_mm = to_mm > from_mm ? std::min(to_mm, at_mm + 0.1) : std::max(to_mm, at_mm - 0.1);
      player->pushDisplacement(at_mm);
      sleepUntil(now_s() + 0.0005);
    }
  };
  moveTo(2);
  player->takeEvents();
  player->takePresses();
  // 0.4 N does not move this one: by its force the finger would be up.
  const auto stiff =
      std::make_unique<HapticProgram>(programOf(buttonOf("stiff", {stateOf("", {{0, 0.9}, {4, 2}}, {})})));
  player->setProgram(*stiff);
  CHECK(player->takeEvents().empty());
  CHECK(player->status().displacement_mm == Approx(2));
  CHECK(player->status().force_N == Approx(1.45).margin(0.01));
  moveTo(4);
  moveTo(0);
  const PressCount former = player->takePresses();  // begun on the button before
  CHECK(former.begun == 0);
  CHECK(former.whole == 0);
  moveTo(4);
  moveTo(0);
  const PressCount own = player->takePresses();
  CHECK(own.begun == 1);
  CHECK(own.whole == 1);
}

TEST_CASE("silent: a press goes over to its speed") {
  const auto peakAt = [](double at_mm) {
    return buttonOf("peak", {stateOf("", {{0, 0.1}, {at_mm, 0.8}, {2.2, 0.4}, {4, 1.1}},
                                     {{0, 0.05}, {at_mm, 0.3}, {2.2, 0.25}, {4, 1}})});
  };
  const Button family = *familyOf({peakAt(1), peakAt(1.5)}, {10, 150});
  const Result<PreparedProgram> front = prepareProgram(family, {}, {});
  auto player = *LivePlayer::startSilent(*prepareLive(*front, family, {}, {}));
  const auto jumpOfPress = [&](double pause_s) {
    player->takeEvents();
    for (int i = 0; i <= 300; ++i) {
      player->pushDisplacement(0.01 * i);
      sleepUntil(now_s() + pause_s);
    }
    double jump_mm = 0;
    for (const EngineEvent& e : player->takeEvents())
      if (e.kind == EventKind::pressJump) jump_mm = e.displacement_mm;
    for (int i = 300; i >= 0; --i) player->pushDisplacement(0.01 * i);
    return jump_mm;
  };
  CHECK(jumpOfPress(0.002) == Approx(1).margin(0.03));  // 5 mm/s at most
  CHECK(player->status().speed_mm_per_s < 6);
  CHECK(jumpOfPress(0) == Approx(1.5).margin(0.03));
  CHECK(player->status().speed_mm_per_s > 150);
}

TEST_CASE("silent: displacement readings, and readings no finger can make") {
  const auto player = silent(linearButton());
  for (int i = 0; i <= 20; ++i) {
    player->pushDisplacement(0.1 * i);
    sleepUntil(now_s() + 0.001);
  }
  player->pushDisplacement(std::nan(""));
  player->pushForce(1e9);
  CHECK(player->status().displacement_mm == Approx(2));
  CHECK(player->status().force_N == Approx(0.4).margin(1e-6));
}

TEST_CASE("silent: a sensor is followed and let go; traces need a device") {
  const auto player = silent(linearButton());
  const PressTrace trace{PressTrace::Quantity::force_N, {{0, 0}, {0.1, 1}}};
  CHECK(player->playTrace(trace, 0.1).failure().exitCode() == 2);
  CHECK_FALSE(player->tracePlaying());

  PtySensor pty;
  if (!pty.ready()) return;
  REQUIRE(player->attachSensor(pty.port(), 230400, {}));
  for (int i = 0; i <= 60; ++i) {
    char line[40];
    std::snprintf(line, sizeof line, "%d,%.4fN\n", i * 2353, 0.4 * i / 60);
    pty.send(line);
    sleepUntil(now_s() + 1 / 425.0);
  }
  CHECK(within(1, [&] { return player->status().displacement_mm > 1.99; }));
  CHECK(player->status().sensor != SensorCondition::none);
  player->detachSensor();
  CHECK(player->status().sensor == SensorCondition::none);
  player->detachSensor();
}

TEST_CASE("silent: without a sensor no reader runs, nor any other thread") {
  const std::ptrdiff_t before = threads();
  const auto player = silent(tactileButton());
  pressTo(*player, 1);
  CHECK(threads() == before);
  PtySensor pty;
  if (!pty.ready()) return;
  REQUIRE(player->attachSensor(pty.port(), 230400, {}));
  CHECK(threads() == before + 1);
  player->detachSensor();
  CHECK(threads() == before);
}
