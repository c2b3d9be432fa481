// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/playback/realtime/callback_guard.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <mutex>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

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
