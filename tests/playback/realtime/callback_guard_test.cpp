// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/realtime/callback_guard.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <mutex>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "model/speed_family.h"
#include "playback/prepare/prepare_speeds.h"
#include "playback/realtime/live_session.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {
bool skipped() {
  if (guardWorks()) return false;
  std::cout << "SKIPPED callback guard: a sanitizer owns malloc in this build\n";
  return true;
}
}  // namespace

TEST_CASE("guard: fires for allocation, release, lock and write") {
  if (skipped()) return;
  const auto hitsOf = [](auto&& what) {
    resetGuard();
    {
      GuardedScope scope;
      what();
    }
    return guardHits();
  };
  std::unique_ptr<int> held = std::make_unique<int>(1);
  CHECK(hitsOf([&] { held.reset(); }) == 1);
  CHECK(firstGuardHit() == "free");
  CHECK(hitsOf([&] { held = std::make_unique<int>(2); }) == 1);
  CHECK(firstGuardHit() == "malloc");
  std::vector<double> growing;
  CHECK(hitsOf([&] { growing.push_back(1); }) >= 1);
  std::mutex mutex;
  CHECK(hitsOf([&] { std::lock_guard lock(mutex); }) == 1);
  CHECK(hitsOf([&] { CHECK_NOTHROW(::write(-1, "", 0)); }) >= 1);
  CHECK(hitsOf([] {}) == 0);
  resetGuard();
  held.reset();  // outside a scope nothing is counted
  CHECK(guardHits() == 0);
}

TEST_CASE("guard: the callback makes no guarded call over 10,000 events") {
  if (skipped()) return;
  const auto first = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
  const auto second = std::make_unique<HapticProgram>(programOf(lockingButton()));
  LiveSession session(48000);
  session.send(Lane::control, {CommandKind::program, TimeBase::now, 0, 0, {}, first.get()});
  resetGuard();
  std::vector<float> out(64);
  const std::vector<float> samples(5000, 0.1f);
  const SoundTake take{samples.data(), samples.size(), 0.1};
  std::uint64_t events = 0;
  int i = 0;
  for (; events < 10000 && i < 400000; ++i) {
    const double now_s = i * 64 / 48000.0;
    const double phase = std::fmod(now_s, 0.12) / 0.12;
    session.send(Lane::sensor,
                 {CommandKind::force, TimeBase::clock, now_s - 1e-4, 4 * std::sin(M_PI * phase), {}, {}});
    if (i % 50 == 0)
      session.send(Lane::network,
                   {CommandKind::burst, TimeBase::clock, now_s - 1e-4, 0, {390, 0.02, 0.5}, {}});
    if (i % 3000 == 1500) {
      const HapticProgram* next = (i / 3000) % 2 == 0 ? second.get() : first.get();
      session.send(Lane::control, {CommandKind::program, TimeBase::now, 0, 0, {}, next});
    }
    if (i % 900 == 0) {
      SessionCommand command;
      command.kind = CommandKind::take;
      command.take = i % 1800 == 0 ? &take : nullptr;
      session.send(Lane::control, command);
    }
    if (i % 700 == 0)
      session.send(Lane::control, {CommandKind::gain, TimeBase::now, 0, 0.5 + 0.1 * (i % 3), {}, {}});
    {
      GuardedScope scope;
      session.process(out.data(), out.size(), now_s);
      session.account(1e-5, out.size(), false);
    }
    SessionReport report;
    while (session.receive(report)) {
      if (report.kind == ReportKind::event) ++events;
    }
  }
  CHECK(events >= 10000);
  INFO(firstGuardHit());
  CHECK(guardHits() == 0);
}

TEST_CASE("guard: the callback makes no guarded call while a press goes over to its speed") {
  if (skipped()) return;
  const Button family = *familyOf(
      {tactileButton(), buttonOf("stiff", {stateOf("", {{0, 0.1}, {1.4, 0.9}, {2, 0.5}, {3, 0.8}, {4, 1.2}},
                                                   {{0, 0.05}, {1, 0.3}, {1.6, 0.2}, {3, 0.4}, {4, 1.1}})})},
      {10, 150});
  const Result<PreparedProgram> front = prepareProgram(family, {}, {});
  const auto live = std::make_unique<LiveProgram>(*prepareLive(*front, family, {}, {}));
  LiveSession session(48000);
  SessionCommand command;
  command.kind = CommandKind::program;
  command.program = &live->program;
  command.speeds = &live->speeds;
  session.send(Lane::control, command);
  resetGuard();
  std::vector<float> out(64);
  SessionReport report;
  std::vector<double> jumps_mm;
  double phase = 0;
  for (int i = 0; i < 40000; ++i) {
    const double now_s = i * 64 / 48000.0, lasts_s = 0.1 + 0.9 * std::fmod(now_s, 7) / 7;
    phase = std::fmod(phase + 64 / 48000.0 / lasts_s, 1);
    session.send(Lane::sensor,
                 {CommandKind::force, TimeBase::clock, now_s, 1.5 * std::sin(M_PI * phase), {}, {}});
    {
      GuardedScope scope;
      session.process(out.data(), out.size(), now_s);
    }
    while (session.receive(report))
      if (report.kind == ReportKind::event && report.event.kind == EventKind::pressJump)
        jumps_mm.push_back(report.event.displacement_mm);
  }
  INFO(firstGuardHit());
  CHECK(guardHits() == 0);
  REQUIRE(jumps_mm.size() > 50);
  CHECK(*std::max_element(jumps_mm.begin(), jumps_mm.end()) >
        *std::min_element(jumps_mm.begin(), jumps_mm.end()) + 0.05);
}
