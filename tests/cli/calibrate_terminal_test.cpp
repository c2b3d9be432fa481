// SPDX-License-Identifier: GPL-3.0-or-later
// `detent-play calibrate` at a terminal, with sensors that are not as kind as those of
// docs/guide/first-button.md.

#include <atomic>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <thread>

#include <catch2/catch.hpp>

#include "playback/device/steady_clock.h"
#include "tests/cli/run_program.h"
#include "tests/cli/terminal_program.h"
#include "tests/playback/device/pty_sensor.h"

using namespace detent::playback;
using detent::test::PtySensor;
using detent::tests::ProgramFolder;
using detent::tests::TerminalProgram;

namespace {

/// Sends the value of `counts` 400 times a second; its argument is the time since the start in s.
class Sensor {
 public:
  using Counts = std::function<double(double time_s)>;
  Sensor(PtySensor& pty, Counts counts)
      : thread_([this, &pty, counts = std::move(counts)] { run(pty, counts); }) {}
  ~Sensor() {
    stopping_ = true;
    thread_.join();
  }

 private:
  void run(PtySensor& pty, const Counts& counts) {
    const double began_s = now_s();
    while (!stopping_) {
      char line[40];
      const double time_s = now_s() - began_s;
      std::snprintf(line, sizeof line, "%u,%ld\n", static_cast<unsigned>(1e6 * time_s),
                    std::lround(counts(time_s)));
      pty.send(line);
      sleepUntil(now_s() + 1.0 / 400);
    }
  }

  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// Output of `calibrate` for one weighing of 50 g on such a sensor. `before`: readings that were sent before
/// the program listened.
std::string weighed(const Sensor::Counts& counts, const std::string& before = "") {
  const ProgramFolder folder("calibrate_terminal_test");
  PtySensor pty;
  REQUIRE(pty.ready());
  pty.send(before);
  TerminalProgram program({DETENT_PLAY, "calibrate", "--sensor", pty.port(), "-o", "my.device"},
                          folder.path());
  REQUIRE(program.shows("Lay a weight", 10));
  const Sensor sensor(pty, counts);
  program.type("50\n");
  REQUIRE(program.shows(" readings", 30));
  program.shows("warning", 0.3);
  program.type("\n");
  CHECK(program.exitCode(10) == 3);  // one weight makes no calibration
  CHECK(folder.files().empty());
  return program.screen();
}

double meanIn(const std::string& screen) {
  const std::string label = "0.4903 N: ";
  const std::size_t at = screen.find(label);
  REQUIRE(at != std::string::npos);
  return std::stod(screen.substr(at + label.size()));
}

}  // namespace

TEST_CASE("calibrate: what stood in the port before is no reading of this weight") {
  std::string old;
  for (int i = 0; i < 100; ++i) old += std::to_string(2500 * i) + ",900\n";
  const std::string screen = weighed([](double) { return 100; }, old);
  INFO(screen);
  CHECK(meanIn(screen) == Approx(100));
  CHECK(screen.find("warning") == std::string::npos);
}

TEST_CASE("calibrate: a reading that still moves is waited for") {
  const std::string screen = weighed([](double t) { return 200 + 40 * std::min(t, 2.5); });
  INFO(screen);
  CHECK(meanIn(screen) == Approx(300));
  CHECK(screen.find("warning") == std::string::npos);
}

TEST_CASE("calibrate: a reading that never rests and one that is noisy are reported") {
  const std::string creeping = weighed([](double t) { return 200 + 20 * t; });
  INFO(creeping);
  CHECK(creeping.find("still drifts") != std::string::npos);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 40);
  const std::string noisy = weighed([&](double) { return 300 + noise(random); });
  INFO(noisy);
  CHECK(noisy.find("is much") != std::string::npos);
}

TEST_CASE("calibrate: masses as people write them, and what is none") {
  const ProgramFolder folder("calibrate_terminal_test");
  PtySensor pty;
  REQUIRE(pty.ready());
  TerminalProgram program({DETENT_PLAY, "calibrate", "--sensor", pty.port(), "-o", "my.device"},
                          folder.path());
  REQUIRE(program.shows("Lay a weight", 10));
  const Sensor sensor(pty, [](double) { return 100; });
  for (const char* nonsense : {"heavy", "-5", "nan", "5 lb", "1e999"}) {
    const std::size_t from = program.screen().size();
    program.type(std::string(nonsense) + "\n");
    CHECK(program.shows("\"" + std::string(nonsense) + "\" is no mass", 5, from));
  }
  for (const auto& [typed, force] : {std::pair{"20,5", "0.2010 N: 100"}, {"0.05 kg", "0.4903 N: 100"}}) {
    program.type(std::string(typed) + "\n");
    CHECK(program.shows(force, 20));
  }
}
