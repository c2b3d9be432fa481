// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/realtime/live_session.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "playback/realtime/stream_clock.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

TEST_CASE("stream clock: late wake-ups do not move the line, a restart does") {
  StreamClock clock(48000);
  std::mt19937 random(3);
  std::int64_t frame = 0;
  for (int i = 0; i < 2000; ++i, frame += 64) {
    const double late_s = i % 7 == 0 ? 0 : 1e-4 * (static_cast<double>(random() % 1000) / 1000);
    clock.onCallback(10 + static_cast<double>(frame) / 48000 + late_s, frame, 64);
    if (i > 50) CHECK(std::fabs(clock.frameAt(10) - 0) < 1.0);
  }
  clock.onCallback(20, frame, 64);
  CHECK(clock.frameAt(20) == Approx(static_cast<double>(frame)));
}

TEST_CASE("session: a time-stamped message sounds one block after its time, whatever the callback's jitter") {
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  LiveSession session(48000);
  session.send(Lane::control, {CommandKind::program, TimeBase::now, 0, 0, {}, program.get()});
  std::mt19937 random(5);
  std::vector<float> out(64);
  std::vector<double> delays;
  double sent_s = -1;
  for (int i = 0; i < 20000; ++i) {
    const double start_s = 100 + i * 64 / 48000.0;
    session.process(out.data(), 64, start_s + 5e-5 * (static_cast<double>(random() % 1000) / 1000));
    for (std::size_t k = 0; k < out.size() && sent_s > 0; ++k) {
      if (std::fabs(out[k]) < 1e-4f) continue;
      delays.push_back(start_s + static_cast<double>(k) / 48000 - sent_s);
      sent_s = -1;
    }
    if (i % 50 == 25) {
      sent_s = start_s + 1e-4 + 1.1e-3 * (static_cast<double>(random() % 1000) / 1000);
      REQUIRE(
          session.send(Lane::network, {CommandKind::burst, TimeBase::clock, sent_s, 0, {390, 0.01, 0.8}}));
    }
    SessionReport report;
    while (session.receive(report)) {
    }
  }
  REQUIRE(delays.size() > 300);
  std::sort(delays.begin(), delays.end());
  CHECK(delays[delays.size() * 95 / 100] - delays[delays.size() * 5 / 100] < 1e-4);
  CHECK(delays[delays.size() / 2] == Approx(64 / 48000.0).margin(1e-4));
}

TEST_CASE("session: without a stream programs come home and take over, at whatever rate the next one has") {
  const auto a = std::make_unique<HapticProgram>(programOf(linearButton()));
  const auto b = std::make_unique<HapticProgram>(programOf(tactileButton()));
  LiveSession session(48000);
  session.send(Lane::control, {CommandKind::program, TimeBase::now, 0, 0, {}, a.get()});
  std::vector<float> out(256);
  session.process(out.data(), out.size(), 0);
  std::size_t home = 0;
  const auto takeReports = [&] {
    SessionReport report;
    while (session.receive(report)) home += report.kind == ReportKind::retired ? 1 : 0;
  };
  for (int i = 0; i < 100; ++i) {
    session.send(Lane::control, {CommandKind::program, TimeBase::now, 0, 0, {}, b.get()});
    session.send(Lane::network, {CommandKind::burst, TimeBase::now, 0, 0, {390, 0.5, 0.8}});
  }
  session.takeWhileAway();
  takeReports();
  CHECK(home == 100);
  session.send(Lane::trace, {CommandKind::force, TimeBase::streamFrames, 300, 0.9, {}, nullptr});
  session.setSampleRate(96000);
  CHECK(session.sampleRate_Hz() == 96000);
  session.process(out.data(), out.size(), 1);
  // events of the time without a stream do not sound
  CHECK(std::all_of(out.begin(), out.end(), [](float v) { return v == 0; }));
  session.send(Lane::network, {CommandKind::burst, TimeBase::now, 0, 0, {1000, 0.1, 0.8}});
  session.process(out.data(), out.size(), 1 + 256 / 96000.0);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double t = static_cast<double>(i) / 96000;
    CHECK(out[i] == Approx(0.8 * (1 - t / 0.1) * std::sin(2 * M_PI * 1000 * t)).margin(1e-6));
  }
}

namespace {

/// Blocks of a session, and the takes that came home.
struct Takes {
  LiveSession session{48000};
  std::vector<const SoundTake*> home;
  float peak = 0;

  bool play(const SoundTake* take) {
    SessionCommand command;
    command.kind = CommandKind::take;
    command.take = take;
    return session.send(Lane::control, command);
  }
  void gain(double gain) { session.send(Lane::control, {CommandKind::gain, TimeBase::now, 0, gain, {}}); }
  std::vector<float> next(std::size_t count) {
    std::vector<float> out(count);
    session.process(out.data(), count, 0);
    SessionReport report;
    while (session.receive(report)) {
      if (report.kind == ReportKind::takeEnded) home.push_back(report.endedTake);
      if (report.kind == ReportKind::status) peak = std::max(peak, report.status.peak);
    }
    return out;
  }
};

std::vector<float> tone(double amplitude, std::size_t count) {
  std::vector<float> samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = static_cast<float>(amplitude * std::sin(2 * M_PI * 200 * static_cast<double>(i) / 48000));
  return samples;
}

}  // namespace

TEST_CASE("session: a take is played sample for sample, beside the engine, and comes home once") {
  const std::vector<float> samples = tone(0.7, 3000);
  const SoundTake take{samples.data(), samples.size(), 0.7};
  Takes rig;
  REQUIRE(rig.play(&take));
  std::vector<float> heard;
  while (heard.size() < 4096)
    for (const float v : rig.next(128)) heard.push_back(v);
  for (std::size_t i = 0; i < heard.size(); ++i) CHECK(heard[i] == (i < samples.size() ? samples[i] : 0));
  CHECK(rig.home == std::vector<const SoundTake*>{&take});
  CHECK(rig.peak == Approx(0.7).margin(1e-3));

  // With a burst of the engine: the sum, held at full scale.
  rig.play(&take);
  rig.session.send(Lane::network, {CommandKind::burst, TimeBase::now, 0, 0, {200, 0.05, 0.9}});
  for (const float v : rig.next(3000)) CHECK(std::fabs(v) <= 1);
}

TEST_CASE("session: a take is never raised beyond full scale, and follows the gain") {
  const std::vector<float> samples = tone(0.5, 9600);
  const SoundTake take{samples.data(), samples.size(), 0.5};
  Takes rig;
  rig.gain(0.1);
  rig.play(&take);
  const std::vector<float> quiet = rig.next(480);
  for (std::size_t i = 0; i < quiet.size(); ++i) CHECK(quiet[i] == Approx(0.1f * samples[i]).margin(1e-6));
  rig.gain(10);
  rig.next(4800);  // past the ramp
  const std::vector<float> loud = rig.next(480);
  for (std::size_t i = 0; i < loud.size(); ++i) CHECK(loud[i] == Approx(2 * samples[5280 + i]).margin(1e-5));
}

TEST_CASE("session: a take that is stopped or replaced fades out, and nothing of it stays") {
  const std::vector<float> one(48000, 0.5f), other = tone(0.3, 960);
  const SoundTake first{one.data(), one.size(), 0.5}, second{other.data(), other.size(), 0.3};
  Takes rig;
  rig.play(&first);
  rig.next(256);
  rig.play(nullptr);
  const std::vector<float> fading = rig.next(480);
  CHECK(fading[0] == Approx(0.5).margin(1e-6));
  CHECK(fading[120] == Approx(0.25).margin(1e-3));
  CHECK(fading[241] == 0);
  CHECK(rig.home == std::vector<const SoundTake*>{&first});

  rig.play(&first);
  rig.next(256);
  rig.play(&second);
  const std::vector<float> mixed = rig.next(960);
  CHECK(mixed[60] == Approx(0.5 * (1 - 60 / 240.0) + other[60]).margin(1e-5));
  CHECK(mixed[500] == other[500]);
  CHECK(rig.home.size() == 3);

  rig.play(&first);
  rig.next(256);
  rig.session.takeWhileAway();  // the device has gone
  rig.play(&second);
  rig.session.takeWhileAway();
  for (const float v : rig.next(256)) CHECK(v == 0);
  CHECK(rig.home.size() == 5);
}

TEST_CASE("session: programs come home, status and events arrive, a full lane refuses") {
  const auto a = std::make_unique<HapticProgram>(programOf(linearButton()));
  const auto b = std::make_unique<HapticProgram>(programOf(tactileButton()));
  LiveSession session(48000);
  session.send(Lane::control, {CommandKind::program, TimeBase::now, 0, 0, {}, a.get()});
  session.send(Lane::control, {CommandKind::program, TimeBase::now, 0, 0, {}, b.get()});
  session.send(Lane::trace, {CommandKind::force, TimeBase::streamFrames, 0, 0, {}, nullptr});
  session.send(Lane::trace, {CommandKind::force, TimeBase::streamFrames, 100, 0.9, {}, nullptr});
  std::vector<float> out(256);
  bool retired = false;
  int events = 0, statuses = 0;
  for (int i = 0; i < 40; ++i) {
    session.process(out.data(), out.size(), i * 256 / 48000.0);
    session.account(1e-5, out.size(), i == 3);
    SessionReport report;
    while (session.receive(report)) {
      if (report.kind == ReportKind::retired) retired = report.retired == a.get();
      if (report.kind == ReportKind::event) ++events;
      if (report.kind == ReportKind::status) {
        ++statuses;
        CHECK(report.status.xruns <= 1);
      }
    }
  }
  CHECK(retired);
  CHECK(events > 20);
  CHECK(statuses >= 5);
  int taken = 0;
  while (session.send(Lane::sensor, {})) ++taken;
  CHECK(taken >= 4096);
}

namespace {

/// A session with one program, whose finger is known by its displacement.
class DisplacedFinger {
 public:
  DisplacedFinger() {
    send({CommandKind::program, TimeBase::now, 0, 0, {}, program_.get()});
    render();
  }
  void send(const SessionCommand& command) { REQUIRE(session_.send(Lane::control, command)); }
  void at(double displacement_mm) {
    send({CommandKind::displacement, TimeBase::now, 0, displacement_mm, {}, nullptr});
    render();
  }
  void render(int blocks = 40) {
    for (int i = 0; i < blocks; ++i, time_s_ += 64 / 48000.0) session_.process(out_.data(), 64, time_s_);
    for (SessionReport report; session_.receive(report);) {
      if (report.kind == ReportKind::status) status_ = report.status;
    }
  }
  std::uint64_t jumps() const { return status_.counts.pressJumps; }
  std::uint64_t grains() const { return status_.counts.grains; }
  double displacement_mm() const { return status_.position.displacement_mm; }
  double time_s() const { return time_s_; }
  LiveSession& session() { return session_; }
  const HapticProgram* program() const { return program_.get(); }

 private:
  std::unique_ptr<HapticProgram> program_ = std::make_unique<HapticProgram>(programOf(tactileButton()));
  LiveSession session_{48000};
  std::vector<float> out_ = std::vector<float>(64);
  SessionStatus status_;
  double time_s_ = 100;
};

}  // namespace

TEST_CASE("session: an exchange of programs leaves a finger that is known by its displacement where it is") {
  DisplacedFinger finger;
  for (double at_mm = 0; at_mm < 1.5; at_mm += 0.05) finger.at(at_mm);
  REQUIRE(finger.jumps() == 1);
  const double before_mm = finger.displacement_mm();
  const auto same = std::make_unique<HapticProgram>(*finger.program());
  finger.send({CommandKind::program, TimeBase::now, 0, 0, {}, same.get()});
  finger.render();
  CHECK(finger.displacement_mm() == Approx(before_mm));
  finger.at(1.5);
  CHECK(finger.jumps() == 1);
  CHECK(finger.displacement_mm() == Approx(1.5).margin(1e-6));
}

TEST_CASE("session: what a finger went through unheard is not played afterwards") {
  DisplacedFinger finger;
  finger.at(0.2);
  const std::uint64_t grains = finger.grains();
  SECTION("a reading that waited too long gives the position only") {
    finger.send({CommandKind::displacement, TimeBase::clock, finger.time_s() - 0.5, 3.2, {}, nullptr});
    finger.render();
  }
  SECTION("the device was away") {
    finger.session().takeWhileAway();
    finger.at(3.2);
  }
  CHECK(finger.grains() == grains);
  CHECK(finger.jumps() == 0);
  CHECK(finger.displacement_mm() == Approx(3.2).margin(1e-6));
  finger.at(3.6);
  CHECK(finger.grains() > grains);
}

TEST_CASE("session: another trace takes the place of readings that were sent ahead") {
  DisplacedFinger finger;
  const auto ahead = [&](double frames, double at_mm) {
    finger.send({CommandKind::displacement, TimeBase::streamFrames, 64 * 40 + frames, at_mm, {}, nullptr});
  };
  ahead(4000, 1.0);
  ahead(8000, 2.5);
  finger.send({CommandKind::forget, TimeBase::now, 0, 0, {}, nullptr});
  finger.send({CommandKind::resyncDisplacement, TimeBase::now, 0, 0, {}, nullptr});
  finger.render(400);
  CHECK(finger.grains() == 0);
  CHECK(finger.jumps() == 0);
  CHECK(finger.displacement_mm() < 0.05);
}
