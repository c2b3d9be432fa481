// SPDX-License-Identifier: GPL-3.0-or-later
// detent-play force as a program, against a microcontroller and an ODrive at the far end of a pty, with a
// handle and a finger on them: what reaches the hand, whatever the link and the firmware do. Issue 25,
// sections 1 and 2; [!shouldfail] as in safety_test.cpp.

#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "playback/force_feedback.h"
#include "tests/cli/run_program.h"
#include "tests/playback/plant/closed_loop.h"
#include "tests/playback/plant/finger.h"
#include "tests/playback/plant/judged.h"
#include "tests/playback/plant/odrive_emulator.h"
#include "tests/playback/plant/serial_emulator.h"

using namespace detent;
using namespace detent::test;

namespace {

struct Ran {
  int exitCode = 0;
  std::string said;  ///< stderr
  nlohmann::json json;
  bool refused() const { return exitCode != 0; }
};

Ran play(const std::string& button, const std::string& device, std::vector<std::string> options) {
  static std::atomic<int> count{0};
  const tests::ProgramFolder folder("plant_device_" + std::to_string(++count));
  std::vector<std::string> words = {"force", DETENT_SOURCE_DIR "/samples/buttons/" + button + ".button.json",
                                    "--device", device, "--json"};
  words.insert(words.end(), options.begin(), options.end());
  const tests::ProgramResult result = folder.run(DETENT_PLAY, words);
  Ran ran{result.exitCode, result.err, nlohmann::json::parse(result.out, nullptr, false)};
  return ran;
}

/// Comes down at 0.5 s, stays on the bottom of B until 1.1 s, goes.
Plan oneFirmPress() {
  Presses press;
  press.to_mm = 9;
  press.wait_s = 0.5;
  press.rest_s = 0.4;
  return pressing(press);
}

PtySettings withFinger() {
  PtySettings pty;
  pty.plan = oneFirmPress();
  return pty;
}

/// The motor's force while the finger stands on the bottom: its mean, and how much it shakes.
struct Felt {
  double mean_N = 0, shaking_N = 0;
  /// A force that a hand can use: there, and steady under a finger that is.
  bool useful() const { return mean_N > 0.5 && shaking_N < 0.1 + 0.2 * mean_N; }
};
Felt feltAtBottom(const PtyDevice& device) {
  double sum_N = 0, squares = 0;
  int count = 0;
  for (const PtyMoment& moment : device.moments()) {
    if (moment.time_s < 0.85 || moment.time_s > 1.0) continue;
    sum_N += moment.motor_N;
    squares += moment.motor_N * moment.motor_N;
    ++count;
  }
  if (count == 0) return {};
  const double mean_N = sum_N / count;
  return {mean_N, std::sqrt(std::max(0.0, squares / count - mean_N * mean_N))};
}

struct SerialRun {
  Ran ran;
  Felt felt{};
  double largest_N = 0;
  Witness device{};
};
SerialRun serialAt(double replyDelay_s) {
  SerialEmulatorSettings settings;
  settings.pty = withFinger();
  settings.pty.replyDelay_s = replyDelay_s;
  SerialEmulator device(settings);
  SerialRun run{
      play("B", "serial:" + device.port(), {"--seconds", "1.3", "--max-N", "3", "--step-mm", "0.001"})};
  device.halt();
  run.felt = feltAtBottom(device);
  run.largest_N = device.largestMotor_N();
  run.device = device.witness(3.0001);
  return run;
}

}  // namespace

TEST_CASE("a microcontroller that answers at once gives the force of the graph and no more", "[serial]") {
  const SerialRun run =
      undisturbed([] { return serialAt(0); }, [](const SerialRun& r) { return r.felt.useful(); });
  if (!judged(run.device, "a microcontroller that answers at once")) return;
  INFO(run.ran.said);
  CHECK(run.ran.exitCode == 0);
  CHECK(run.felt.useful());
  CHECK(run.largest_N <= 3.0001);
}

TEST_CASE("replies of 1 to 8 ms: useful force, or a refusal with the reason", "[serial]") {
  const std::vector<double> delays_s = {0.001, 0.002, 0.004, 0.008};
  std::vector<std::future<SerialRun>> runs;
  for (double delay_s : delays_s) {
    runs.push_back(std::async(std::launch::async, [delay_s] {
      return undisturbed([delay_s] { return serialAt(delay_s); },
                         [](const SerialRun& r) { return r.ran.refused() || r.felt.useful(); });
    }));
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SerialRun run = runs[i].get();
    if (!judged(run.device, "a microcontroller that answers late")) continue;
    INFO(delays_s[i] * 1000 << " ms, exit code " << run.ran.exitCode << ": " << run.ran.said);
    CHECK(run.largest_N <= 3.0001);
    if (run.ran.refused()) {
      CHECK(run.ran.said.find("ms") != std::string::npos);
      CHECK(run.largest_N < 0.05);
    } else {
      CHECK(run.felt.useful());
    }
  }
}

TEST_CASE("bad bytes, a reset and a pulled plug give no more than the largest force", "[serial]") {
  std::vector<std::future<double>> runs;
  for (int fault = 0; fault < 3; ++fault) {
    runs.push_back(std::async(std::launch::async, [fault] {
      SerialEmulatorSettings settings;
      settings.pty = withFinger();
      if (fault == 0) settings.pty.brokenAnswers = 0.1;
      if (fault == 1) settings.pty.resetAt_s = 0.9;
      if (fault == 2) settings.pty.unplugAt_s = 0.8;
      if (fault == 2) settings.pty.pluggedAgain_s = 0.2;
      SerialEmulator device(settings);
      play("B", "serial:" + device.port(), {"--seconds", "1.6", "--max-N", "1.5", "--step-mm", "0.001"});
      device.halt();
      double largest_N = device.largestMotor_N();
      for (const PtyMoment& moment : device.moments()) {
        // Silence of the firmware: 50 ms after the plug was pulled there is nothing left.
        if (fault == 2 && moment.time_s > 0.86 && moment.time_s < 0.99 && moment.motor_N != 0) largest_N = 99;
      }
      return largest_N;
    }));
  }
  for (std::size_t fault = 0; fault < runs.size(); ++fault) {
    INFO("fault " << fault);
    CHECK(runs[fault].get() <= 1.5001);
  }
}

TEST_CASE("an uploaded table gives no more than the largest force either", "[upload]") {
  for (const char* button : {"B", "push", "latch"}) {
    SerialEmulatorSettings settings;
    settings.pty = withFinger();
    settings.pty.plan = pressing({-1, 30, 6, 0.3, 0.1, 0.3, 0.1, 0});
    SerialEmulator device(settings);
    const Ran ran = play(button, "serial:" + device.port(),
                         {"--seconds", "1", "--max-N", "1", "--step-mm", "0.001", "--upload"});
    device.halt();
    INFO(button << ", exit code " << ran.exitCode << ": " << ran.said);
    CHECK(device.largestMotor_N() <= 1.0001);
  }
}

namespace {

struct Uploaded {
  Ran ran;
  UploadedTable table{};
  Witness device{};
  bool ranTable() const { return !table.rows.empty(); }
};
Uploaded uploaded(const std::string& button) {
  SerialEmulator device({});
  Uploaded run{play(button, "serial:" + device.port(),
                    {"--seconds", "0.2", "--max-N", "5", "--step-mm", "0.001", "--upload"})};
  device.halt();
  run.table = device.table();
  run.device = device.witness(5.0001);
  return run;
}

}  // namespace

TEST_CASE("a button with graphs at several speeds is not uploaded, with the way out", "[upload]") {
  const Uploaded run = undisturbed([] { return uploaded("../../tests/model/file/fixtures/version-5"); },
                                   [](const Uploaded& r) { return r.ran.exitCode == 2; });
  if (!judged(run.device, "a button with graphs at several speeds")) return;
  INFO(run.ran.said);
  CHECK(run.ran.exitCode == 2);
  CHECK_FALSE(run.ranTable());
  CHECK_THAT(run.ran.said,
             Catch::Contains("can hold the force of only one speed; this button has graphs at 3") &&
                 Catch::Contains("detent-graph convert makes one"));
}

TEST_CASE("uploaded, by the host and simulated: the same force under the same limits", "[upload]") {
  for (const char* button : {"B", "push"}) {
    const Uploaded run =
        undisturbed([&] { return uploaded(button); }, [](const Uploaded& r) { return r.ranTable(); });
    if (!judged(run.device, std::string("uploaded: ") + button)) continue;
    INFO(button << ": " << run.ran.said);
    REQUIRE(run.ranTable());
    playback::ForceDeviceProfile profile = playback::simulatedDevice();
    profile.limits.force_N = 5;
    auto program = std::make_unique<playback::ForceProgram>(preparedFor(sampleButton(button), profile));
    playback::ForceEngine engine(*program);
    const auto forceAt = [&](double position_mm) {
      playback::ForceReading reading;
      reading.position_mm = position_mm;
      return engine.step(reading).force_N;
    };
    for (int k = 0; k < 400; ++k) forceAt(-0.5);
    for (double at_mm = -0.5; at_mm < 5.5; at_mm += 0.0005) {  // at 0.5 mm/s damping is negligible
      const double host_N = forceAt(at_mm), uploaded_N = std::min(5.0, run.table.force_N(at_mm, true, 0));
      INFO(button << " at " << at_mm << " mm");
      REQUIRE(std::abs(host_N - uploaded_N) < 0.03);
    }
  }
}

namespace {

struct Exchanged {
  double largest_N = 0, gone_s = -1,
         risen_s = -1;    ///< times at which the force was gone and was back, from the exchange on
  double overRamp_N = 0;  ///< largest force above the ramp while the force rises
  double worst_N = 1e9;   ///< largest difference between the table and the other button, both strokes
  int rowsSent = 0;       ///< rows sent, including lost ones
  std::string refused{};
  Witness device{};
};

constexpr double uploaded_N = 3;
playback::ForcePlayerSettings uploadingTo(const PtyDevice& device) {
  playback::ForcePlayerSettings player;
  player.device = *playback::forceDeviceFrom("serial:" + device.port());
  player.device.uploadTable = true;
  player.device.profile.step_mm = 0.001;
  player.device.profile.limits.force_N = uploaded_N;
  return player;
}
void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// A finger holds 3 mm; the uploaded `from` becomes `to` under it.
Exchanged exchanged(const std::string& from, const std::string& to, double replyDelay_s,
                    SerialEmulatorSettings settings = {}) {
  constexpr double max_N = uploaded_N, ramp_s = 0.2;
  settings.pty.plan = holding(3, 0.5);
  settings.pty.start_mm = 3;
  settings.pty.replyDelay_s = replyDelay_s;
  SerialEmulator device(settings);
  const playback::ForcePlayerSettings player = uploadingTo(device);
  Exchanged e;
  {
    const auto running = playback::ForcePlayer::start(sampleButton(from), player);
    if (!running) {
      device.halt();
      return Exchanged{.refused = running.failure().sentence(), .device = device.witness(max_N + 1e-4)};
    }
    pause(0.5);
    const Result<Done> taken = (*running)->setButton(sampleButton(to));
    if (!taken) e.refused = taken.failure().sentence();
    // A line with each answer, and the ramp.
    pause(1.2 + 300 * replyDelay_s);
  }
  device.halt();
  e.device = device.witness(max_N + 1e-4);
  e.rowsSent = device.rowsSinceTable();
  e.largest_N = device.largestMotor_N();
  bool was = false;
  for (const PtyMoment& moment : device.moments()) {
    was = was || moment.motor_N > 0.2;
    if (was && e.gone_s < 0 && moment.motor_N == 0) e.gone_s = moment.time_s;
    if (e.gone_s >= 0 && e.risen_s < 0 && moment.motor_N != 0) e.risen_s = moment.time_s;
    if (e.risen_s >= 0)
      e.overRamp_N = std::max(
          e.overRamp_N, std::abs(moment.motor_N) - max_N * (moment.time_s - e.risen_s + 0.003) / ramp_s);
  }
  const playback::ForceProgram program = preparedFor(sampleButton(to), player.device.profile);
  const playback::ForceStateTable& forceAt = program.states[0];
  const UploadedTable& got = device.table();
  e.worst_N = 0;
  for (std::size_t i = 0; i < got.rows.size(); ++i) {
    const double at_mm = got.first_mm + got.spacing_mm * static_cast<double>(i);
    const long row = std::lround((at_mm - forceAt.first_mm) / forceAt.spacing_mm);
    // The device may still hold the table of `from`, whose travel is another.
    if (row < 0 || row >= static_cast<long>(forceAt.rowCount)) {
      e.worst_N = std::numeric_limits<double>::infinity();
      break;
    }
    const playback::ForceRow& expected = forceAt.rows[static_cast<std::size_t>(row)];
    e.worst_N = std::max({e.worst_N, std::abs(got.rows[i].press_N - expected.press_N),
                          std::abs(got.rows[i].release_N - expected.release_N)});
  }
  return e;
}

}  // namespace

TEST_CASE(
    "an edit reaches a device that runs an uploaded table: without force meanwhile, then along the ramp",
    "[upload]") {
  for (const double replyDelay_s : {0.0, 0.004}) {
    const Exchanged e =
        undisturbed([&] { return exchanged("A", "B", replyDelay_s); },
                    [](const Exchanged& r) {
                      return r.risen_s > r.gone_s + 0.05 && r.worst_N < 0.03 && r.overRamp_N <= 0;
                    });
    if (!judged(e.device, "an edit of an uploaded table")) continue;
    INFO("answers after " << replyDelay_s << " s; gone at " << e.gone_s << " s, back at " << e.risen_s);
    CHECK(e.refused.empty());
    CHECK(e.gone_s > 0);
    CHECK(e.risen_s > e.gone_s + 0.05);
    CHECK(e.overRamp_N <= 0);
    CHECK(e.largest_N <= 3.0001);
    CHECK(e.worst_N < 0.03);
  }
}

TEST_CASE("rows that get lost on a link slower than eight questions are missed: the table has no hole",
          "[upload]") {
  SerialEmulatorSettings settings;
  settings.rows = 24;
  settings.losesRow = 3;
  const auto fine = [&](const Exchanged& r) {
    // Every row was sent at least twice, because its acknowledgement comes after it is due again.
    return r.risen_s > r.gone_s + 0.05 && r.worst_N < 0.03 &&
           r.rowsSent >= 2 * static_cast<int>(settings.rows);
  };
  const Exchanged e = undisturbed([&] { return exchanged("A", "B", 0.012, settings); }, fine);
  if (!judged(e.device, "rows that get lost")) return;
  INFO("gone at " << e.gone_s << " s, back at " << e.risen_s << " s, " << e.rowsSent << " rows sent "
                  << e.refused);
  CHECK(e.rowsSent >= 2 * static_cast<int>(settings.rows));
  CHECK(e.worst_N < 0.03);
  CHECK(e.risen_s > e.gone_s + 0.05);
  CHECK(e.largest_N <= 3.0001);
}

namespace {

struct Regained {
  double before_N = 0, untilArmed_N = 0, after_N = 0;  ///< largest
  playback::ForceHalt forceAt{};
  std::string refused{};
  Witness device{};
  bool fine(playback::ForceHalt halt) const {
    return before_N > 0.3 && untilArmed_N == 0 && forceAt == halt && after_N > 0.3 &&
           after_N <= uploaded_N + 1e-4;
  }
};

/// A finger presses again and again; something happens at 1 s, a person arms at 1.6 s.
Regained regained(SerialEmulatorSettings settings, double replyDelay_s) {
  settings.rows = 24;
  settings.pty.plan = pressing({-1, 6, 0, 0.1, 0.1, 0.2, 0.1, 0.5});  // up at 1 s
  settings.pty.sceneWaits = true;
  settings.pty.replyDelay_s = replyDelay_s;
  SerialEmulator device(settings);
  Regained r;
  double armed_s = 0;
  {
    const auto running = playback::ForcePlayer::start(sampleButton("A"), uploadingTo(device));
    if (!running) {
      device.halt();
      return Regained{.refused = running.failure().sentence(), .device = device.witness(uploaded_N + 1e-4)};
    }
    armed_s = 1.6;
    pause(armed_s);
    r.forceAt = (*running)->status().halt;
    (*running)->rearm();
    pause(1.2 + 26 * replyDelay_s);  // a line with each answer
  }
  device.halt();
  r.device = device.witness(uploaded_N + 1e-4);
  for (const PtyMoment& moment : device.moments()) {
    double& most_N = moment.time_s < 1 ? r.before_N : moment.time_s < armed_s ? r.untilArmed_N : r.after_N;
    if (moment.time_s > 1 && moment.time_s < 1.06) continue;
    most_N = std::max(most_N, std::abs(moment.motor_N));
  }
  return r;
}

}  // namespace

TEST_CASE("the loss of an uploaded table is reported, and arming brings its force back, on a slow link too",
          "[upload]") {
  using playback::ForceHalt;
  SerialEmulatorSettings reset, away, stopped;
  reset.pty.resetAt_s = 1;
  away.pty.unplugAt_s = 1;
  away.pty.pluggedAgain_s = 0.1;
  stopped.stopAt_s = 1;
  struct Taken {
    const char* what;
    SerialEmulatorSettings settings;
    ForceHalt halt;
  };
  const std::vector<Taken> all = {Taken{"reset", reset, ForceHalt::displaced},
                                  Taken{"away", away, ForceHalt::displaced},
                                  Taken{"stopped by its switch", stopped, ForceHalt::stopped}};
  for (const double replyDelay_s : {0.0, 0.004, 0.012}) {
    std::vector<std::future<Regained>> runs;
    for (const Taken& taken : all) {
      runs.push_back(std::async(std::launch::async, [&taken, replyDelay_s] {
        return undisturbed([&] { return regained(taken.settings, replyDelay_s); },
                           [&](const Regained& one) { return one.fine(taken.halt); });
      }));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Taken& taken = all[i];
      const Regained r = runs[i].get();
      if (!judged(r.device, std::string("the loss of an uploaded table: ") + taken.what)) continue;
      INFO(taken.what << ", answers after " << replyDelay_s << " s " << r.refused);
      CHECK(r.before_N > 0.3);
      CHECK(r.untilArmed_N == 0);
      CHECK(r.forceAt == taken.halt);
      CHECK(r.after_N > 0.3);
      CHECK(r.after_N <= uploaded_N + 1e-4);
    }
  }
}

TEST_CASE("an edit that no uploaded table holds is refused with the reason, and the table goes on",
          "[upload]") {
  const Exchanged e = undisturbed([] { return exchanged("A", "latch", 0); },
                                  [](const Exchanged& r) { return r.largest_N > 0.2; });
  if (!judged(e.device, "an edit that no uploaded table holds")) return;
  CHECK_THAT(e.refused, Catch::Contains("can run only one state; this button has 2"));
  CHECK(e.largest_N > 0.2);
}

namespace {

struct OdriveRun {
  Ran ran;
  Felt felt{};
  double largest_N = 0, firmwareLimit_N = 0, velocityLimit_mm_per_s = 0;
  bool expired = false, armed = false;
  Witness device{};
};
constexpr double digits_N = 0.01;  // torques have six digits
OdriveRun odrive(OdriveEmulatorSettings settings, const std::string& max_N = "3") {
  OdriveEmulator device(settings);
  OdriveRun run{play("B", "odrive:" + device.port(),
                     {"--seconds", "1.3", "--max-N", max_N, "--step-mm", "0.001", "--mm-per-turn", "60"})};
  device.halt();
  run.felt = feltAtBottom(device);
  run.largest_N = device.largestMotor_N();
  run.firmwareLimit_N = device.armedTorqueLimit_N();
  run.velocityLimit_mm_per_s = device.armedVelocityLimit_mm_per_s();
  run.expired = device.watchdogExpired();
  run.armed = device.everArmed();
  run.device = device.witness(std::stod(max_N) + digits_N);
  return run;
}
OdriveEmulatorSettings odriveWithFinger() {
  OdriveEmulatorSettings settings;
  settings.pty = withFinger();
  return settings;
}

/// The same press with replies of 4 and 8 ms, and of 30 ms, which a watchdog of 50 ms just bears.
const std::vector<OdriveRun>& lateOdrives() {
  static const std::vector<OdriveRun> runs = [] {
    std::vector<std::future<OdriveRun>> running;
    for (double delay_s : {0.004, 0.008, 0.03}) {
      OdriveEmulatorSettings settings = odriveWithFinger();
      settings.pty.replyDelay_s = delay_s;
      running.push_back(std::async(std::launch::async, [settings] {
        return undisturbed(
            [settings] { return odrive(settings); },
            [](const OdriveRun& r) { return !r.expired && (r.ran.refused() || r.felt.useful()); });
      }));
    }
    std::vector<OdriveRun> done;
    for (std::future<OdriveRun>& one : running) done.push_back(one.get());
    return done;
  }();
  return runs;
}

}  // namespace

TEST_CASE("an ODrive gives the force of the graph and no more", "[odrive]") {
  const OdriveRun run = undisturbed([] { return odrive(odriveWithFinger()); },
                                    [](const OdriveRun& r) { return r.felt.useful() && !r.expired; });
  if (!judged(run.device, "an ODrive that answers at once")) return;
  INFO(run.ran.said);
  CHECK(run.ran.exitCode == 0);
  CHECK(run.armed);
  CHECK_FALSE(run.expired);
  CHECK(run.felt.useful());
  CHECK(run.largest_N <= 3.01);  // torques have six digits
}

TEST_CASE("an ODrive receives the largest force", "[odrive]") {
  const OdriveRun run =
      undisturbed([] { return odrive(odriveWithFinger(), "1"); }, [](const OdriveRun& r) { return r.armed; });
  if (!judged(run.device, "an ODrive's largest force")) return;
  INFO(run.ran.said);
  CHECK(run.armed);
  CHECK(run.firmwareLimit_N <= 1.05);
}

TEST_CASE("an axis in error is no force, and said", "[odrive]") {
  OdriveEmulatorSettings failed = odriveWithFinger(), fails = odriveWithFinger();
  failed.errorAtStart = 0x40;  // motor failed; clearing it once is allowed, calling it fine is not
  fails.errorAt_s = 0.7;
  auto first = std::async(std::launch::async, [&] { return odrive(failed); });
  const auto saysError = [](const OdriveRun& r) { return r.ran.said.find("error") != std::string::npos; };
  const OdriveRun later = undisturbed([&] { return odrive(fails); }, saysError), sooner = first.get();
  if (!judged(later.device, "an ODrive in error")) return;
  INFO(sooner.ran.said << "; " << later.ran.said);
  CHECK((sooner.ran.refused() || saysError(sooner)));
  CHECK(saysError(later));
}

TEST_CASE("an ODrive that answers late is not lost to its own watchdog", "[odrive]") {
  for (const OdriveRun& run : lateOdrives()) {
    if (!judged(run.device, "an ODrive that answers late")) continue;
    INFO("exit code " << run.ran.exitCode << ": " << run.ran.said);
    CHECK_FALSE(run.expired);
    CHECK(run.largest_N <= 3.01);
  }
}

TEST_CASE("an ODrive that answers late: useful force, or a refusal with the reason", "[odrive]") {
  for (const OdriveRun& run : lateOdrives()) {
    if (!judged(run.device, "an ODrive that answers late")) continue;
    INFO(run.felt.mean_N << " N, shaking by " << run.felt.shaking_N << " N, exit code " << run.ran.exitCode
                         << ": " << run.ran.said);
    CHECK((run.ran.refused() ? run.ran.said.find("ms") != std::string::npos : run.felt.useful()));
  }
}

TEST_CASE("an ODrive's own velocity limit is out of a finger's reach", "[odrive]") {
  OdriveEmulatorSettings settings = odriveWithFinger();
  settings.velocityLimit = 2;
  const OdriveRun run =
      undisturbed([&] { return odrive(settings); }, [](const OdriveRun& r) { return r.armed; });
  if (!judged(run.device, "an ODrive's velocity limit")) return;
  INFO(run.ran.said);
  CHECK(run.armed);
  CHECK(run.largest_N <= 3.01);
  // The speed limit of docs/guide/force-feedback.md is 2 m/s.
  CHECK(run.velocityLimit_mm_per_s >= 2000);
}

TEST_CASE("an ODrive that comes back with another count gives force of the right place, or says why none",
          "[odrive]") {
  OdriveEmulatorSettings settings = odriveWithFinger();
  settings.pty.unplugAt_s = 0.3;  // before the press: the handle is at rest
  settings.pty.pluggedAgain_s = 0.1;
  settings.pty.resetAt_s = 0.35;
  const auto fine = [](const OdriveRun& r) {
    const bool forceAt = r.ran.refused() || r.ran.said.find("place") != std::string::npos;
    return r.felt.useful() || (forceAt && r.felt.mean_N == 0);
  };
  const OdriveRun run = undisturbed([&] { return odrive(settings); }, fine);
  if (!judged(run.device, "an ODrive that comes back")) return;
  INFO(run.felt.mean_N << " N, shaking by " << run.felt.shaking_N << " N; " << run.ran.said);
  CHECK(run.largest_N <= 3.01);
  CHECK(fine(run));
}
