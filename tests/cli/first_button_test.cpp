// SPDX-License-Identifier: GPL-3.0-or-later
// docs/guide/first-button.md as a person would follow it: its own command lines, at a terminal, with the
// sketch of samples/firmware on a simulated sensor behind a pty and a simulated transducer on a sound server.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>
#include <mutex>
#include <random>
#include <thread>

#include <catch2/catch.hpp>

#include "playback/device/steady_clock.h"
#include "playback/measurement/calibrate.h"
#include "playback/measurement/profile_file.h"
#include "playback/realtime/biquad.h"
#include "tests/cli/run_program.h"
#include "tests/cli/terminal_program.h"
#include "tests/playback/device/jack_rig.h"
#include "tests/playback/device/pty_sensor.h"

using namespace detent;
using namespace detent::playback;
using namespace detent::test;
using detent::tests::ProgramFolder;
using detent::tests::ProgramResult;
using detent::tests::TerminalProgram;

namespace {

/// force on the sensor, set by the simulated finger
std::atomic<double> force_N{0};

/// One line of docs/reference/serial-protocol.md: a sensor whose conductance rises with the force, 10 kOhm to
/// 0 V, one count of noise.
std::string readingAt(std::uint32_t time_us) {
  static std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.5);
  const double share = force_N / 5;
  const auto counts = std::lround(1023 * share / (1 + share) + noise(random));
  std::string line = std::to_string(time_us) + "," + std::to_string(counts);
  unsigned checksum = 0;
  for (const char c : line) checksum ^= static_cast<unsigned char>(c);
  char tail[8];
  std::snprintf(tail, sizeof tail, "*%02X\n", checksum);
  return line + tail;
}

/// Sensor and microcontroller: 1000 readings a second into a pty.
class Microcontroller {
 public:
  Microcontroller() : thread_([this] { run(); }) {}
  ~Microcontroller() {
    stopping_ = true;
    thread_.join();
    force_N = 0;
  }
  const std::string& port() const { return pty_.port(); }
  /// The longest that the board or the finger stood still: neither does, but a thread does on a machine that
  /// has other work.
  double longestHalt_s() const { return std::max(boardsHalt_s_.load(), fingersHalt_s_.load()); }
  std::string lastLines() {
    const std::lock_guard lock(mutex_);
    return lines_;
  }
  /// A finger: up to `peak_N` and back, each in `stroke_s`, with a hold between.
  void press(double peak_N, double stroke_s, double hold_s) {
    const double began_s = now_s();
    double last_s = 0;
    for (double t = 0; t < 2 * stroke_s + hold_s; t = now_s() - began_s) {
      fingersHalt_s_ = std::max(fingersHalt_s_.load(), t - last_s);
      last_s = t;
      const double down = std::min(t / stroke_s, (2 * stroke_s + hold_s - t) / stroke_s);
      force_N = peak_N * std::clamp(down, 0.0, 1.0);
      sleepUntil(now_s() + 0.001);
    }
    force_N = 0;
  }

 private:
  void run() {
    const double began_s = now_s();
    pty_.send("# detent-force 1 fsr400 divider 1023\r\n");
    double last_s = began_s, next_s = began_s;
    while (!stopping_) {
      const double at_s = now_s();
      boardsHalt_s_ = std::max(boardsHalt_s_.load(), at_s - last_s);
      last_s = at_s;
      const std::string line = readingAt(static_cast<std::uint32_t>((at_s - began_s) * 1e6));
      pty_.send(line);
      {
        const std::lock_guard lock(mutex_);
        lines_ += line;
        if (lines_.size() > 400) lines_.erase(0, lines_.size() - 200);
      }
      next_s = std::max(next_s + 0.001,
                        at_s - 0.01);  // after a stall no burst of old times, as the sketch does it
      sleepUntil(next_s);
    }
  }

  PtySensor pty_;
  std::mutex mutex_;
  std::string lines_;
  std::atomic<bool> stopping_{false};
  std::atomic<double> boardsHalt_s_{0}, fingersHalt_s_{0};
  std::thread thread_;
};

/// The paper's transducer: 260, 390 and 780 Hz; its first `broken_s` seconds lose 10 ms of every 0.7 s.
class SimulatedTransducer {
 public:
  explicit SimulatedTransducer(double broken_s)
      : broken_s_(broken_s), listener_([this](float x) { return move(x); }) {
    listener_.keepConnected("PortAudio.*:out_0", "PortAudio.*:in_0");
  }
  bool ready() const { return listener_.ready(); }
  /// Blocks that the sound server itself says it lost.
  std::uint64_t losses() const { return listener_.xruns(); }

 private:
  float move(float x) {
    if (peaks_.empty()) {
      for (const auto& [frequency_Hz, gain_dB] : {std::pair{260.0, 9.0}, {390.0, 14.0}, {780.0, 12.0}}) {
        peaks_.emplace_back();
        peaks_.back().setCoefficients(peaking(48000, frequency_Hz, 8, gain_dB));
      }
    }
    double v = 0.1 * static_cast<double>(x);
    for (Biquad& peak : peaks_) peak.process(&v, 1);
    const double time_s = static_cast<double>(count_++) / 48000;
    const bool lost = time_s < broken_s_ && std::fmod(time_s, 0.7) > 0.69;
    return lost ? 0 : static_cast<float>(v);
  }

  double broken_s_;
  std::vector<Biquad> peaks_;
  std::int64_t count_ = 0;
  JackListener listener_;  // last member, because it calls move
};

/// The page's command lines: indented lines that begin with detent-play, with `port` in place of the board's
/// port.
std::vector<std::vector<std::string>> commandsOfThePage(const std::string& port) {
  std::ifstream page(DETENT_SOURCE_DIR "/docs/guide/first-button.md");
  std::vector<std::vector<std::string>> commands;
  const std::string indented = "    detent-play ";
  for (std::string line; std::getline(page, line);) {
    if (line.rfind(indented, 0) != 0) continue;
    std::istringstream words(line.substr(4));
    std::vector<std::string> command;
    for (std::string word; words >> word;) command.push_back(word == "/dev/ttyACM0" ? port : word);
    command.front() = DETENT_PLAY;
    commands.push_back(command);
  }
  return commands;
}

std::vector<std::string> commandWith(const std::vector<std::vector<std::string>>& commands,
                                     const std::string& word) {
  const auto at = std::find_if(commands.begin(), commands.end(), [&](const auto& c) { return c[1] == word; });
  REQUIRE(at != commands.end());
  return *at;
}

bool near(const DeviceProfile& profile, double frequency_Hz) {
  return std::any_of(profile.resonances.begin(), profile.resonances.end(),
                     [&](const Resonance& r) { return std::fabs(r.frequency_Hz / frequency_Hz - 1) < 0.02; });
}

DeviceProfile profileIn(const ProgramFolder& folder) {
  const Result<DeviceProfile> profile = parseDeviceProfile(folder.read("my.device"), "my.device");
  INFO((profile ? std::string() : profile.failure().sentence()));
  REQUIRE(profile);
  return *profile;
}

void calibrate(const std::vector<std::string>& command, const ProgramFolder& folder) {
  TerminalProgram program(command, folder.path());
  REQUIRE(program.shows("Lay a weight", 5));
  for (const double mass_g : {0.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    const std::size_t from = program.screen().size();
    force_N = 1e-3 * mass_g * standardGravity_m_per_s2;
    program.type(std::to_string(mass_g) + "\n");
    REQUIRE(program.shows(" readings", 20, from));
  }
  force_N = 0;
  program.type("\n");
  CHECK(program.exitCode(5) == 0);
  INFO(program.screen());
  CHECK(program.screen().find("residual") != std::string::npos);
  CHECK(program.screen().find("warning") == std::string::npos);
  const DeviceProfile profile = profileIn(folder);
  CHECK(profile.sensor.weights == 7);
  CHECK(profile.sensor.residual_N < 0.05);
  CHECK(profile.sensor.noise_N > 0);
}

void play(const std::vector<std::string>& command, const ProgramFolder& folder, Microcontroller& board) {
  TerminalProgram program(command, folder.path());
  REQUIRE(program.shows("q ends", 10));
  REQUIRE(program.shows("sensor runs", 10));
  sleepUntil(now_s() + 1);  // the program learns the sensor's noise before the first press
  board.press(1.2, 0.15, 0.1);
  CHECK(program.shows("jumps 2 ", 5));
  program.type("q");
  CHECK(program.exitCode(5) == 0);
  INFO(program.screen());
  CHECK(program.screen().find("1 press jumps, 1 release jumps, 1 bottom-outs") != std::string::npos);
  // The one expected warning, which the page mentions: the sweep's equalizer spares the jumps. A board that
  // stops is reported, too.
  const std::size_t said = program.screen().find("warning:");
  CHECK(said != std::string::npos);
  INFO("the simulated board or finger halted for up to " << board.longestHalt_s() << " s");
  constexpr double noticed_s = 0.003;  // three readings: the force's step is a finger's no more
  if (board.longestHalt_s() < noticed_s)
    CHECK(program.screen().find("warning:", said + 1) == std::string::npos);
}

}  // namespace

TEST_CASE("first button: every step of the page does what it says one should see") {
  // A sweep stands at no deadline: blocks of 85 ms play on where a machine shared with others halts for as
  // long.
  JackServer server(4096);
  if (!server.ready()) {
    std::cout << "SKIPPED the first button's page: " << server.whyNot() << "\n";
    return;
  }
  const ProgramFolder folder("first_button_test");
  std::filesystem::create_directory_symlink(DETENT_SOURCE_DIR "/samples", folder.path() / "samples");
  Microcontroller board;
  const auto commands = commandsOfThePage(board.port());

  sleepUntil(now_s() + 0.2);
  const std::string lines = board.lastLines();
  INFO(lines);
  CHECK(lines.find(',') != std::string::npos);
  CHECK(lines.find('*') != std::string::npos);

  calibrate(commandWith(commands, "calibrate"), folder);
  {
    const SimulatedTransducer transducer(0);
    REQUIRE(transducer.ready());
    TerminalProgram sweep(commandWith(commands, "sweep"), folder.path());
    const int code = sweep.exitCode(150);
    INFO(sweep.screen());
    if (code == 5 && transducer.losses() > 1) {
      std::cout << "SKIPPED the rest of the first button's page: the sound server lost "
                << transducer.losses() << " blocks of its own, so that no two runs of the sweep are whole\n";
      return;
    }
    CHECK(code == 0);
    const DeviceProfile profile = profileIn(folder);
    CHECK(profile.resonances.size() == 3);
    for (const double frequency_Hz : {260.0, 390.0, 780.0}) CHECK(near(profile, frequency_Hz));
    CHECK(profile.sensor.weights == 7);
    CHECK(folder.files().count("response.svg") == 1);
  }
  folder.write("my.device", folder.read("my.device") +
                                "transducer.power_W = 3\ntransducer.impedance_ohm = 4\n"
                                "transducer.full_scale_V = 5\n");
  CHECK(profileIn(folder).transducer.highestLevel() == Approx(std::sqrt(12.0) / 5));
  play(commandWith(commands, "samples/buttons/B.button.json"), folder, board);
}

TEST_CASE("sweep: on a machine too busy to play it writes the truth or nothing") {
  JackServer server(256);
  if (!server.ready()) {
    std::cout << "SKIPPED a sweep under load: " << server.whyNot() << "\n";
    return;
  }
  const ProgramFolder folder("sweep_load_test");
  const SimulatedTransducer transducer(9);
  REQUIRE(transducer.ready());
  std::atomic<bool> busy{true};
  std::vector<std::thread> others;
  for (int i = 0; i < 4; ++i) {
    others.emplace_back([&] {
      for (volatile double x = 1; busy;) x = x * 1.0000001;
    });
  }
  TerminalProgram sweep({DETENT_PLAY, "sweep", "--seconds", "2", "-o", "my.device"}, folder.path());
  const int code = sweep.exitCode(100);
  busy = false;
  for (std::thread& other : others) other.join();
  INFO(sweep.screen());
  CHECK(sweep.screen().find("does not count") != std::string::npos);
  if (code != 0) {
    CHECK(code == 5);
    CHECK(folder.files().empty());
    return;
  }
  const DeviceProfile profile = profileIn(folder);
  CHECK(profile.resonances.size() == 3);
  for (const double frequency_Hz : {260.0, 390.0, 780.0}) CHECK(near(profile, frequency_Hz));
}
