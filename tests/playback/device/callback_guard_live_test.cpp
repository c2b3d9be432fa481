// SPDX-License-Identifier: GPL-3.0-or-later
// 10,000 events through PortAudio and JACK: the callback of a running stream makes no guarded call.

#include <iostream>
#include <memory>

#include <catch2/catch.hpp>

#include "playback/device/audio_device.h"
#include "playback/device/steady_clock.h"
#include "tests/playback/device/jack_rig.h"
#include "tests/playback/realtime/callback_guard.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

TEST_CASE(
    "guard: a running callback, JACK's or PortAudio's, allocates, locks and waits for nothing over 10,000 "
    "events") {
  JackServer server(64);
  if (!server.ready() || !guardWorks()) {
    std::cout << "SKIPPED guard in a running stream: "
              << (guardWorks() ? server.whyNot() : std::string("a sanitizer owns malloc in this build"))
              << "\n";
    return;
  }
  const auto first = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
  const auto second = std::make_unique<HapticProgram>(programOf(tactileButton()));
  LiveSession session(48000);
  SessionCommand use;
  use.kind = CommandKind::program;
  use.program = first.get();
  session.send(Lane::control, use);
  resetGuard();
  AudioSettings settings;
  settings.device = "JACK";
  settings.jackRoute = GENERATE(JackRoute::ownClient, JackRoute::portAudio);
  auto output = AudioOutput::open(settings, session, {enterGuard, leaveGuard});
  REQUIRE(output);
  std::uint64_t events = 0;
  SessionReport report;
  const double end_s = now_s() + 30;
  for (int i = 0; events < 10000 && now_s() < end_s; ++i) {
    SessionCommand force;
    force.timeBase = TimeBase::clock;
    force.time = now_s();
    force.value = i % 100 < 50 ? 0.08 * (i % 50) : 4 - 0.08 * (i % 50);
    session.send(Lane::sensor, force);
    if (i % 500 == 0) {
      use.program = i % 1000 == 0 ? second.get() : first.get();
      session.send(Lane::control, use);
    }
    while (session.receive(report)) events += report.kind == ReportKind::event ? 1 : 0;
    sleepUntil(now_s() + 0.0004);
  }
  (*output).reset();
  CHECK(events >= 10000);
  INFO(firstGuardHit());
  CHECK(guardHits() == 0);
}
