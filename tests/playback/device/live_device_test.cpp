// SPDX-License-Identifier: GPL-3.0-or-later
// The live path on a real sound server: JACK with its dummy driver.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "model/speed_family.h"
#include "playback/device/audio_device.h"
#include "playback/device/signal_server.h"
#include "playback/device/steady_clock.h"
#include "playback/measurement/sweep.h"
#include "playback/playback.h"
#include "playback/realtime/biquad.h"
#include "tests/playback/device/jack_rig.h"
#include "tests/playback/device/pty_sensor.h"
#include "tests/playback/sample_buttons.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

namespace {

constexpr int attempts = 5;  // a virtual machine stalls now and then; an xrun says so

bool skipped(const JackServer& server, const char* what) {
  if (server.ready()) return false;
  std::cout << "SKIPPED " << what << ": " << server.whyNot() << "\n";
  return true;
}

PlayerSettings jackSettings() {
  PlayerSettings settings;
  settings.device = "JACK Audio Connection Kit: system";
  return settings;
}

PressTrace raisedCosine(double duration_s, double peak_N) {
  PressTrace trace;
  for (double t = 0; t <= duration_s; t += 1 / 425.0) {
    trace.readings.push_back({t, peak_N * 0.5 * (1 - std::cos(2 * M_PI * t / duration_s))});
  }
  return trace;
}

std::size_t firstSound(const std::vector<float>& samples) {
  return static_cast<std::size_t>(
      std::find_if(samples.begin(), samples.end(), [](float v) { return v != 0; }) - samples.begin());
}

struct ProcessUse {
  double cpu_s = 0;
  long resident_bytes = 0;
};

ProcessUse useOfThisProcess() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  long all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return {seconds(use.ru_utime) + seconds(use.ru_stime), resident * ::sysconf(_SC_PAGESIZE)};
}

template <class Condition>
bool within(double seconds, Condition condition) {
  for (const double end = now_s() + seconds; now_s() < end; sleepUntil(now_s() + 0.01)) {
    if (condition()) return true;
  }
  return condition();
}

}  // namespace

TEST_CASE("live: what JACK hears is the offline render, bit for bit") {
  JackServer server(256);
  if (skipped(server, "captured sound against the offline render")) return;
  const auto program = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
  const PressTrace trace = raisedCosine(0.6, 4);
  const Result<RenderedPress> offline = renderPress(*program, trace, {});
  REQUIRE(offline);
  std::vector<float> expected = offline->samples;
  expected.erase(expected.begin(), expected.begin() + static_cast<long>(firstSound(expected)));
  while (!expected.empty() && expected.back() == 0) expected.pop_back();
  REQUIRE(expected.size() > 10000);

  const bool throughPortAudio = GENERATE(false, true);
  PlayerSettings settings = jackSettings();
  settings.jackThroughPortAudio = throughPortAudio;
  double worst = 1;
  bool identical = false;
  for (int attempt = 0; attempt < attempts && !identical; ++attempt) {
    Result<std::unique_ptr<LivePlayer>> player = LivePlayer::start(settings, *program);
    REQUIRE(player);
    JackListener listener;
    REQUIRE(listener.ready());
    REQUIRE(listener.listenTo(throughPortAudio ? "PortAudio.*:out_0" : "detent:out_1"));
    sleepUntil(now_s() + 0.1);
    REQUIRE((*player)->playTrace(trace, 0.3));
    REQUIRE(within(3, [&] { return !(*player)->tracePlaying(); }));
    sleepUntil(now_s() + 0.3);
    const std::vector<float> heard = listener.recorded();
    const std::size_t at = firstSound(heard);
    REQUIRE(at < heard.size());
    REQUIRE(heard.size() >= at + expected.size());
    worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      worst = std::max(worst, static_cast<double>(std::fabs(heard[at + i] - expected[i])));
    }
    identical = std::memcmp(heard.data() + at, expected.data(), expected.size() * sizeof(float)) == 0;
    const PlayerStatus status = (*player)->status();
    CHECK(status.counts.late == 0);
    CHECK(status.counts.grains == offline->summary.counts.grains);
    CHECK(status.counts.pressJumps == 2);
    if (!identical && listener.xruns() == 0 && status.xruns == 0) break;
  }
  CHECK(worst < 1e-6);
  CHECK(identical);
}

TEST_CASE("live: the sound device goes away and comes back") {
  JackServer server(256);
  if (skipped(server, "loss and return of the sound device")) return;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  Result<std::unique_ptr<LivePlayer>> started = LivePlayer::start(jackSettings(), *program);
  REQUIRE(started);
  LivePlayer& player = **started;
  CHECK(within(2, [&] { return player.status().blockFrames > 0; }));
  server.stop();
  CHECK(within(5, [&] { return player.status().deviceLost; }));
  player.pushForce(0.3);  // nobody listens; nothing breaks
  server.start();
  REQUIRE(server.ready());
  CHECK(within(8, [&] { return !player.status().deviceLost; }));
  CHECK(player.status().deviceLosses == 1);
  JackListener listener;
  REQUIRE(listener.listenTo("detent:out_1"));
  player.fingerTap(1.5, 0.1);
  CHECK(within(3, [&] {
    const auto heard = listener.recorded();
    return firstSound(heard) < heard.size();
  }));
}

TEST_CASE("live: a stream that closes lets a callback come to its end, however long it takes") {
  JackServer server(256);
  if (skipped(server, "closing within a callback")) return;
  static std::atomic<int> entered{0}, left{0};
  CallbackHooks slow;  // some cycles long: libjack gives up waiting, and cancels the thread it runs on
  slow.enter = [] {
    ++entered;
    const std::string unwound(100, 'x');  // an object that a cancelled thread has to destroy
    for (const double end_s = now_s() + 0.04; now_s() < end_s && !unwound.empty();) {
    }
  };
  slow.leave = [] { ++left; };
  LiveSession session(48000);
  AudioSettings settings;
  settings.device = "JACK Audio Connection Kit: system";
  for (int i = 0; i < 5; ++i) {
    Result<std::unique_ptr<AudioOutput>> output = AudioOutput::open(settings, session, slow);
    REQUIRE(output);
    const int before = entered;
    CHECK(within(2, [&] { return entered > before; }));
    (*output).reset();  // without waiting the whole program ends here, by SIGABRT or SIGSEGV
    CHECK(left == entered);
  }
}

TEST_CASE("live: a JACK output is found by its very name, whatever a regular expression would make of it") {
  JackServer server(256);
  if (skipped(server, "names of JACK outputs")) return;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  JackListener listener({}, "Monitor (HDMI)");
  REQUIRE(listener.ready());
  PlayerSettings settings;
  settings.device = "JACK Audio Connection Kit: Monitor (HDMI)";
  Result<std::unique_ptr<LivePlayer>> player = LivePlayer::start(settings, *program);
  INFO((player ? std::string() : player.failure().sentence()));
  REQUIRE(player);
  (*player)->fingerTap(1.5, 0.1);
  CHECK(within(3, [&] {
    const auto heard = listener.recorded();
    return firstSound(heard) < heard.size();
  }));
}

TEST_CASE("live: while the device is away nothing piles up, and it may come back at another rate") {
  JackServer server(256);
  if (skipped(server, "return of the sound device at another rate")) return;
  const auto tactile = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const auto twoLevel = std::make_unique<HapticProgram>(programOf(twoLevelButton()));
  Result<std::unique_ptr<LivePlayer>> started = LivePlayer::start(jackSettings(), *tactile);
  REQUIRE(started);
  LivePlayer& player = **started;
  CHECK(within(2, [&] { return player.status().blockFrames > 0; }));
  CHECK(player.status().sampleRate_Hz == 48000);
  server.stop();
  REQUIRE(within(5, [&] { return player.status().deviceLost; }));

  const ProcessUse before = useOfThisProcess();
  constexpr double away_s = 3;
  for (const double end_s = now_s() + away_s; now_s() < end_s; sleepUntil(now_s() + 0.005)) {
    player.setProgram(*twoLevel);  // 130 kB each
    player.setGain(1);
    player.pushForce(0.1);
    player.status();
  }
  const ProcessUse after = useOfThisProcess();
  std::cout << "away: " << 100 * (after.cpu_s - before.cpu_s) / away_s << " % of a processor, "
            << static_cast<double>(after.resident_bytes - before.resident_bytes) / 1e6 << " MB more\n";
  CHECK(after.cpu_s - before.cpu_s < 0.25 * away_s);  // 600 programs were prepared to be played, too
  CHECK(after.resident_bytes - before.resident_bytes < 30000000);

  server.start(44100);
  REQUIRE(server.ready());
  CHECK(within(8, [&] { return !player.status().deviceLost; }));
  CHECK(player.status().sampleRate_Hz == 44100);
  const PressTrace trace = raisedCosine(0.6, 4);
  RenderSettings render;
  render.sampleRate_Hz = 44100;
  const Result<RenderedPress> offline = renderPress(*twoLevel, trace, render);
  REQUIRE(offline);
  std::vector<float> expected = offline->samples;
  expected.erase(expected.begin(), expected.begin() + static_cast<long>(firstSound(expected)));
  bool identical = false;
  for (int attempt = 0; attempt < attempts && !identical; ++attempt) {
    JackListener listener;
    REQUIRE(listener.listenTo("detent:out_1"));
    sleepUntil(now_s() + 0.1);
    REQUIRE(player.playTrace(trace, 0.3));
    REQUIRE(within(3, [&] { return !player.tracePlaying(); }));
    sleepUntil(now_s() + 0.3);
    const std::vector<float> heard = listener.recorded();
    const std::size_t at = firstSound(heard);
    REQUIRE(heard.size() >= at + expected.size());
    identical = std::memcmp(heard.data() + at, expected.data(), expected.size() * sizeof(float)) == 0;
  }
  CHECK(identical);
}

TEST_CASE("live: traces from several threads replace each other, the last one plays to its end") {
  JackServer server(256);
  if (skipped(server, "traces from several threads")) return;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  Result<std::unique_ptr<LivePlayer>> started = LivePlayer::start(jackSettings(), *program);
  REQUIRE(started);
  LivePlayer& player = **started;
  const PressTrace trace = raisedCosine(0.2, 1.5);
  std::vector<std::thread> threads;
  std::atomic<int> taken{0};
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 5; ++i) taken += player.playTrace(trace, 0.05) ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(taken == 20);
  CHECK(player.tracePlaying());
  CHECK(within(3, [&] { return !player.tracePlaying(); }));
  CHECK(player.status().counts.bottomOuts >= 1);
}

TEST_CASE(
    "live: what was said while no word got through is heard: the button of all speeds after a trace, the "
    "gain") {
  JackServer server(256);
  if (skipped(server, "a trace's end while the sound server stands still")) return;
  const auto peakAt = [](double at_mm) {
    return buttonOf("peak", {stateOf("", {{0, 0.1}, {at_mm, 0.8}, {2.2, 0.4}, {4, 1.1}}, {})});
  };
  const Button family = *familyOf({peakAt(1), peakAt(1.5)}, {10, 150});
  const Result<PreparedProgram> front = prepareProgram(family, {}, {});
  Result<std::unique_ptr<LivePlayer>> started =
      LivePlayer::start(jackSettings(), *prepareLive(*front, family, {}, {}));
  REQUIRE(started);
  LivePlayer& player = **started;
  REQUIRE(within(2, [&] { return player.status().blockFrames > 0; }));
  std::vector<double> jumps_mm;
  const auto jumped = [&] {
    for (const EngineEvent& e : player.takeEvents())
      if (e.kind == EventKind::pressJump) jumps_mm.push_back(e.displacement_mm);
    return !jumps_mm.empty();
  };
  PressTrace fast{PressTrace::Quantity::displacement_mm, {}};
  for (int ms = 0; ms <= 100; ++ms) fast.readings.push_back({0.001 * ms, std::min(4.0, 0.15 * ms)});
  for (int tries = 0; tries < 5 && !player.tracePlaying(); ++tries) {  // a busy machine may check too late
    jumps_mm.clear();
    REQUIRE(player.playTrace(fast, 0.1));
    REQUIRE(within(2, jumped));
    CHECK(jumps_mm.front() == Approx(1.5).margin(0.03));
  }
  REQUIRE(player.tracePlaying());
  server.pause();
  sleepUntil(now_s() + 0.02);                        // the last callback
  for (int i = 0; i < 6000; ++i) player.setGain(1);  // more than the lane holds
  CHECK(within(3, [&] { return !player.tracePlaying(); }));
  player.setGain(0);
  server.resume();
  const std::uint64_t before = player.status().counts.inputs;
  REQUIRE(within(5, [&] {
    player.pushDisplacement(0);
    return player.status().counts.inputs > before;
  }));
  sleepUntil(now_s() + 0.2);
  player.takeEvents();
  jumps_mm.clear();
  double loudest = 0;
  for (int i = 0; i <= 300; ++i) {
    player.pushDisplacement(0.01 * i);
    loudest = std::max(loudest, player.status().level);
    sleepUntil(now_s() + 0.002);  // 5 mm/s at most
  }
  CHECK(loudest == 0);
  CHECK(within(2, jumped));
  REQUIRE(jumps_mm.size() == 1);
  CHECK(jumps_mm.front() == Approx(1).margin(0.03));
}

TEST_CASE("live: rain comes from the second output alone, at the requested level") {
  JackServer server(256);
  if (skipped(server, "masking noise")) return;
  const auto program = std::make_unique<HapticProgram>(programOf(tactileButton()));
  PlayerSettings settings = jackSettings();
  settings.masking.level = 0.1;
  Result<std::unique_ptr<LivePlayer>> player = LivePlayer::start(settings, *program);
  REQUIRE(player);
  JackListener ears, finger;
  REQUIRE(ears.listenTo("detent:out_2"));
  REQUIRE(finger.listenTo("detent:out_1"));
  sleepUntil(now_s() + 2.2);
  const std::vector<float> heard = ears.recorded(), felt = finger.recorded();
  REQUIRE(heard.size() > 48000);
  double squares = 0;
  for (std::size_t i = heard.size() - 48000; i < heard.size(); ++i)
    squares += static_cast<double>(heard[i]) * static_cast<double>(heard[i]);
  CHECK(std::sqrt(squares / 48000) == Approx(0.1).epsilon(0.2));  // rain comes in gusts
  CHECK(firstSound(felt) == felt.size());
  (*player)->fingerTap(1.5, 0.1);
  CHECK(within(3, [&] { return (*player)->status().counts.releaseJumps == 1; }));
  settings.masking.device = settings.device;
  CHECK(LivePlayer::start(settings, *program).failure().exitCode() == 2);
}

TEST_CASE("live: fingers, sensors and messages are felt; programs exchange under the finger") {
  JackServer server(128);
  if (skipped(server, "live sources")) return;
  const auto tactile = std::make_unique<HapticProgram>(programOf(tactileButton()));
  const auto linear = std::make_unique<HapticProgram>(programOf(linearButton()));
  Result<std::unique_ptr<LivePlayer>> started = LivePlayer::start(jackSettings(), *tactile);
  REQUIRE(started);
  LivePlayer& player = **started;
  player.fingerTap(1.5, 0.15);
  CHECK(within(3, [&] { return player.status().counts.releaseJumps == 1; }));
  CHECK(player.status().counts.pressJumps == 1);
  CHECK(player.status().counts.bottomOuts == 1);
  CHECK_FALSE(player.takeEvents().empty());

  for (int i = 0; i < 20; ++i) player.setProgram(i % 2 == 0 ? *linear : *tactile);
  player.setProgram(*linear);
  sleepUntil(now_s() + 0.05);
  player.fingerTap(1.5, 0.1);
  CHECK(within(3, [&] { return player.status().counts.bottomOuts == 2; }));
  CHECK(player.status().counts.pressJumps == 1);

  player.pushForce(std::nan(""));
  player.pushForce(1e9);

  PtySensor pty;
  if (pty.ready()) {
    REQUIRE(player.attachSensor(pty.port(), 230400, {}));
    const auto before = player.status().counts.grains;
    for (int i = 0; i <= 200; ++i) {
      char line[40];
      std::snprintf(line, sizeof line, "%d,%.4fN\n", i * 2353, 0.7 * i / 200);
      pty.send(line);
      sleepUntil(now_s() + 1 / 425.0);
    }
    const auto running = [&] { return player.status().sensor == SensorCondition::running; };
    CHECK(within(0.1, [&] { return running() || !pty.send("900000,0.7N\n"); }));
    CHECK(within(1, [&] { return player.status().counts.grains - before >= 79; }));
    pty.unplug();
    CHECK(within(2, [&] { return player.status().sensor == SensorCondition::unplugged; }));
  }
  Result<std::uint16_t> port = player.listenFudi(0);
  REQUIRE(port);
  auto sender = SignalSender::open("127.0.0.1", *port);
  REQUIRE(sender);
  SignalMessage jump;
  jump.kind = SignalKind::jump;
  jump.burst = {390, 0.02, 0.8};
  (*sender)->send(jump);
  CHECK(within(1, [&] { return player.status().counts.triggers == 1; }));
  CHECK_FALSE(player.attachSensor("/dev/detent-no-such-port", 230400, {}));
}

TEST_CASE("live: devices are listed, a wrong name is device trouble") {
  JackServer server(256);
  if (skipped(server, "device list")) return;
  const Result<std::vector<SoundDevice>> devices = listSoundDevices();
  REQUIRE(devices);
  CHECK(std::any_of(devices->begin(), devices->end(), [](const SoundDevice& d) {
    return d.name.find("JACK") != std::string::npos && d.outputChannels == 2;
  }));
  PlayerSettings settings;
  settings.device = "no such device";
  const auto program = std::make_unique<HapticProgram>(programOf(linearButton()));
  const auto refused = LivePlayer::start(settings, *program);
  REQUIRE_FALSE(refused);
  CHECK(refused.failure().exitCode() == 6);
  CHECK(refused.failure().sentence().find("no such device") != std::string::npos);
}

TEST_CASE("measure: latency through a loop of the sound server") {
  JackServer server(128);
  if (skipped(server, "latency in loopback")) return;
  JackListener loop;
  REQUIRE(loop.ready());
  loop.keepConnected("detent:out_1", "PortAudio.*:in_0");
  LatencySettings settings;
  settings.player = jackSettings();
  settings.trials = 8;
  const Result<LatencyResult> result = measureLatency(
      settings, [](std::size_t, std::size_t) {}, [] { return false; });
  INFO((result ? std::string() : result.failure().sentence()));
  REQUIRE(result);
  CHECK(result->delays_s.size() >= 7);
  for (double d : result->delays_s) {
    CHECK(d > 0);
    CHECK(d < 0.05112);  // the paper's mean
  }
}

TEST_CASE("measure: a sweep through a known resonance finds it") {
  JackServer server(512);
  if (skipped(server, "sweep in loopback")) return;
  Biquad resonance;
  resonance.setCoefficients(peaking(48000, 390, 8, 15));
  JackListener device([&](float x) {
    double v = 0.1 * static_cast<double>(x);
    resonance.process(&v, 1);
    return static_cast<float>(v);
  });
  REQUIRE(device.ready());
  device.keepConnected("PortAudio.*:out_0", "PortAudio.*:in_0");
  SweepSettings settings;
  settings.duration_s = 2;
  const std::vector<float> played = sweepSignal(settings);
  PlayerSettings player = jackSettings();
  player.sampleRate_Hz = 48000;
  bool found = false;
  for (int attempt = 0; attempt < attempts && !found; ++attempt) {
    const Result<SoundRecording> recorded = playAndRecordSamples(player, "", played, [] { return false; });
    INFO((recorded ? std::string() : recorded.failure().sentence()));
    REQUIRE(recorded);
    const Result<FrequencyResponse> response = analyseSweep(played, recorded->samples, settings);
    if (!response || response->resonances.empty()) continue;
    found = std::fabs(response->resonances[0].frequency_Hz - 390) < 6;
  }
  CHECK(found);
}

TEST_CASE("measure: while one thread records, another lists the devices") {
  JackServer server(512);
  if (skipped(server, "recording beside listing")) return;
  PlayerSettings player = jackSettings();
  player.sampleRate_Hz = 48000;
  const std::vector<float> longer(static_cast<std::size_t>(20 * player.sampleRate_Hz), 0);
  std::atomic<bool> playing{false}, listed{false}, recorded{false}, gaveUp{false};
  std::thread recorder([&] {
    gaveUp = !playAndRecordSamples(player, "", longer, [&] {
      playing = true;
      return listed.load();
    });
    recorded = true;
  });
  while (!playing && !recorded) std::this_thread::yield();
  const bool found = static_cast<bool>(listSoundDevices());
  const bool meanwhile = !recorded;
  listed = true;
  recorder.join();
  CHECK(found);
  CHECK(meanwhile);
  CHECK(gaveUp);
}

TEST_CASE("Pure Data plays the same bursts from the paper's own route") {
  JackServer server(256);
  if (skipped(server, "Pure Data beside Detent")) return;
  if (!programExists("pd")) {
    std::cout << "SKIPPED Pure Data beside Detent: pd is not installed\n";
    return;
  }
  ChildProcess pd({"pd", "-nogui", "-jack", "-r", "48000", "-inchannels", "0", "-outchannels", "2",
                   "-callback", "-open", DETENT_SOURCE_DIR "/samples/puredata/detent.pd"});
  JackListener listener;
  REQUIRE(listener.ready());
  if (!listener.listenTo("pure_data.*:output", 8)) {
    std::cout << "SKIPPED Pure Data beside Detent: pd opens no JACK port here\n";
    return;
  }
  auto sender = SignalSender::open("127.0.0.1", 9001);
  REQUIRE(sender);
  SignalMessage jump;
  jump.kind = SignalKind::jump;
  jump.burst = {390, 0.034, 0.6};
  sleepUntil(now_s() + 0.5);
  (*sender)->send(jump);
  REQUIRE(within(3, [&] {
    const auto heard = listener.recorded();
    return firstSound(heard) + 4800 < heard.size();
  }));
  const auto heard = listener.recorded();
  const std::size_t at = firstSound(heard);
  // The same burst but for Pd's block and ramp granularity: energy within 2 %, best match above 0.99.
  std::vector<double> expected;
  for (int i = 0; i < 1632; ++i) {
    const double t = i / 48000.0;
    expected.push_back(0.6 * (1 - t / 0.034) * std::sin(2 * M_PI * 390 * t));
  }
  double best = 0, energy = 0, own = 0;
  for (double v : expected) own += v * v;
  for (std::size_t i = 0; i < 2400; ++i)
    energy += static_cast<double>(heard[at + i]) * static_cast<double>(heard[at + i]);
  for (int shift = -70; shift <= 70; ++shift) {
    double product = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const long k = static_cast<long>(at + i) + shift;
      if (k >= 0) product += expected[i] * static_cast<double>(heard[static_cast<std::size_t>(k)]);
    }
    best = std::max(best, product / std::sqrt(own * energy));
  }
  CHECK(best > 0.99);
  CHECK(energy == Approx(own).epsilon(0.02));
}
