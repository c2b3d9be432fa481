// SPDX-License-Identifier: GPL-3.0-or-later
// One test per guard of the realtime room that nothing else would miss (tests/faults/faults.toml takes them
// out one by one).

#include <memory>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/realtime/haptic_engine.h"
#include "playback/realtime/live_session.h"
#include "playback/realtime/stroke_tracker.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

std::size_t countOf(const Crossings& crossings, CrossingKind kind) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < crossings.count; ++i) n += crossings.items[i].kind == kind ? 1 : 0;
  return n;
}

/// A button with a press jump at 1 mm, whose release ends just before it, not far enough to arm the jump
/// again.
Button returningButton() {
  return buttonOf("returning",
                  {stateOf("", {{0, 0}, {1, 0.6}, {1.3, 0.45}, {1.6, 0.6}, {3, 1.0}},
                           {{0, 0}, {0.94, 0.05}, {0.95, 0.5}, {1.05, 0.35}, {1.7, 0.5}, {3, 0.9}})});
}

SessionCommand programCommand(const HapticProgram& program) {
  return {CommandKind::program, TimeBase::now, 0, 0, {}, &program};
}

SessionCommand forceAt(TimeBase base, double time, double force_N) {
  return {CommandKind::force, base, time, force_N, {}, nullptr};
}

/// Everything that a session reports.
struct Heard {
  std::vector<EngineEvent> events;
  std::vector<const HapticProgram*> retired;
  SessionStatus status;

  void from(LiveSession& session) {
    SessionReport report;
    while (session.receive(report)) {
      if (report.kind == ReportKind::event) events.push_back(report.event);
      if (report.kind == ReportKind::retired) retired.push_back(report.retired);
      if (report.kind == ReportKind::status) status = report.status;
    }
  }
};

constexpr std::size_t block = 64;
constexpr double block_s = block / 48000.0;

}  // namespace

TEST_CASE("guard: a jump that is crossed again before it is armed is counted and not felt") {
  const auto program = std::make_unique<HapticProgram>(programOf(returningButton()));
  const JumpEntry& jump = program->states[0].press.jumps[0];
  REQUIRE(program->states[0].press.jumpCount == 1);
  REQUIRE(jump.rearm_mm < 0.93);
  StrokeTracker tracker;
  tracker.use(program.get());
  CHECK(countOf(tracker.updateForce(0.62), CrossingKind::pressJump) == 1);
  for (int again = 1; again <= 3; ++again) {
    tracker.updateForce(0.34);
    REQUIRE(tracker.position().displacement_mm > jump.rearm_mm);
    REQUIRE(tracker.position().displacement_mm < jump.from_mm);
    CHECK(countOf(tracker.updateForce(0.62), CrossingKind::pressJump) == 0);
    CHECK(tracker.suppressed() >= static_cast<std::uint64_t>(again));
  }
  // Back to where it is armed again, and it is felt once more.
  tracker.updateForce(0);
  REQUIRE(tracker.position().displacement_mm <= jump.rearm_mm);
  CHECK(countOf(tracker.updateForce(0.62), CrossingKind::pressJump) == 1);
}

TEST_CASE("guard: a bottom that is met again before it is armed is counted and not felt") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  const StateProgram& state = program->states[0];
  REQUIRE(state.hasBottomOut);
  StrokeTracker tracker;
  tracker.use(program.get());
  CHECK(countOf(tracker.updateDisplacement(state.end_mm), CrossingKind::bottomOut) == 1);
  const double between_mm = 0.5 * (state.bottomOutRearm_mm + state.bottomOut_mm);
  tracker.updateDisplacement(between_mm);
  CHECK(countOf(tracker.updateDisplacement(state.end_mm), CrossingKind::bottomOut) == 0);
  CHECK(tracker.suppressed() == 1);
  tracker.updateDisplacement(state.bottomOutRearm_mm - 0.02);
  CHECK(countOf(tracker.updateDisplacement(state.end_mm), CrossingKind::bottomOut) == 1);
}

TEST_CASE("guard: a reading stamped ahead of the stream is felt now, not when its stamp comes") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  LiveSession session(48000);
  REQUIRE(session.send(Lane::control, programCommand(*program)));
  std::vector<float> out(block);
  session.process(out.data(), block, 10);
  REQUIRE(session.send(Lane::sensor, forceAt(TimeBase::clock, 10 + block_s, 0)));
  REQUIRE(session.send(Lane::sensor, forceAt(TimeBase::clock, 11, 0.6)));
  Heard heard;
  for (int i = 1; i <= 30; ++i) {
    session.process(out.data(), block, 10 + i * block_s);
    heard.from(session);
  }
  CHECK(heard.events.size() > 20);
}

TEST_CASE("guard: readings whose stamps run backwards are placed in the order they came") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  LiveSession session(48000);
  REQUIRE(session.send(Lane::control, programCommand(*program)));
  for (int i = 0; i <= 4; ++i)  // one reading less than the output delay, so that nothing is late
    REQUIRE(session.send(Lane::trace, forceAt(TimeBase::streamFrames, 150.0 * i, 0.11 * i)));
  REQUIRE(session.send(Lane::trace, forceAt(TimeBase::streamFrames, 150, 0.65)));
  std::vector<float> out(block);
  Heard heard;
  for (int i = 0; i < 100; ++i) {
    session.process(out.data(), block, i * block_s);
    heard.from(session);
  }
  CHECK(heard.events.size() > 40);
  CHECK(heard.status.counts.late == 0);
}

TEST_CASE("guard: a program sent with a reading is the one the reading is felt on") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  LiveSession session(48000);
  REQUIRE(session.send(Lane::sensor, forceAt(TimeBase::now, 0, 0.6)));
  REQUIRE(session.send(Lane::control, programCommand(*program)));
  std::vector<float> out(block);
  Heard heard;
  for (int i = 0; i < 60; ++i) {
    session.process(out.data(), block, i * block_s);
    heard.from(session);
  }
  CHECK(heard.events.size() > 20);
}

TEST_CASE("guard: a program comes home even if nobody listened for a while") {
  const auto first = std::make_unique<HapticProgram>(programOf(linearButton()));
  const auto second = std::make_unique<HapticProgram>(programOf(tactileButton()));
  LiveSession session(48000);
  REQUIRE(session.send(Lane::control, programCommand(*first)));
  std::vector<float> out(480);
  for (int i = 0; i < 600; ++i) {  // fills the queue of reports: 80 grains each way
    REQUIRE(session.send(Lane::sensor, forceAt(TimeBase::now, 0, i % 2 == 0 ? 1.0 : 0.0)));
    session.process(out.data(), out.size(), i * 0.01);
  }
  REQUIRE(session.send(Lane::control, programCommand(*second)));
  session.process(out.data(), out.size(), 6.0);
  Heard heard;
  heard.from(session);
  REQUIRE(heard.events.size() > 8000);
  for (int i = 1; i < 10; ++i) {
    session.process(out.data(), out.size(), 6.0 + i * 0.01);
    heard.from(session);
  }
  REQUIRE(heard.retired.size() == 1);
  CHECK(heard.retired.front() == first.get());
  CHECK(heard.status.droppedReports > 0);
}

TEST_CASE("guard: what one finger meets sounds in the order travelled, however uneven the stamps") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  HapticEngine engine(48000);
  engine.use(program.get());
  REQUIRE(engine.push({InputKind::force, 0, 0}));
  REQUIRE(engine.push({InputKind::force, 2000, 0.4}));
  REQUIRE(engine.push({InputKind::force, 1500, 0.65}));
  std::vector<float> out(6000);
  engine.render(out.data(), out.size());
  EngineEvent event;
  double reached_mm = 0;
  int grains = 0;
  while (engine.nextEvent(event)) {
    if (event.kind != EventKind::grain) continue;
    CHECK(event.displacement_mm >= reached_mm);
    reached_mm = event.displacement_mm;
    ++grains;
  }
  CHECK(grains > 40);
}
