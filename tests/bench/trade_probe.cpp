// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements for tests/bench/trade that no program's option reaches: one measurement per call, printed as
// numbers in a line.
//
//   trade_probe host BUTTON RATE_HZ          force error (mN rms), bytes on the line a second, bytes before
//   trade_probe upload BUTTON ROWS           the same, of the sample firmware with a table of so many rows

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "model/file/button_file.h"
#include "playback/device/serial_force_device.h"
#include "playback/prepare/prepare_force.h"
#include "playback/realtime/force_engine.h"
#include "tests/playback/device/force_firmware.h"

using namespace detent;
using namespace detent::playback;

namespace {

constexpr double pi = 3.14159265358979323846;

// ---- host loop and table

constexpr double still_s = 1, press_s = 0.16, reach_mm = 3.5, tick_s = 5e-5;
constexpr double end_s = still_s + press_s;

double positionAt(double t) {
  return t < still_s ? 0 : 0.5 * reach_mm * (1 - std::cos(2 * pi * (t - still_s) / press_s));
}
double velocityAt(double t) {
  return t < still_s ? 0 : 0.5 * reach_mm * 2 * pi / press_s * std::sin(2 * pi * (t - still_s) / press_s);
}
double encoded_mm(double t, double step_mm) { return std::floor(positionAt(t) / step_mm) * step_mm; }

/// The force that should act at every moment, against that which does.
class ForceError {
 public:
  explicit ForceError(const ForceProgram& program) : program_(atOnce(program)), law_(program_) {
    law_.restart(0);
  }

  void add(double t, double acting_N) {
    const double wanted_N = law_.step(positionAt(t), velocityAt(t));
    if (t < still_s) return;
    squares_ += (acting_N - wanted_N) * (acting_N - wanted_N);
    ++count_;
  }
  double rms_mN() const { return 1000 * std::sqrt(squares_ / count_); }

 private:
  static ForceProgram atOnce(ForceProgram program) {
    program.law.holdLead_s = 0;
    program.step_mm = 1e-9;
    program.period_s = tick_s;
    return program;
  }
  ForceProgram program_;
  ForceLaw law_;
  double squares_ = 0;
  int count_ = 0;
};

ForceProgram prepared(const char* file, double rate_Hz) {
  const Result<Button> button = readButtonFile(file);
  ForceSettings settings;
  settings.rate_Hz = rate_Hz;
  Result<PreparedForce> force = button ? prepareForce(*button, voiceCoilRig(), settings) : button.failure();
  if (force) return force->program;
  std::fprintf(stderr, "%s\n", force.failure().sentence().c_str());
  std::exit(force.failure().exitCode());
}

int print(const ForceError& error, double bytesPerSecond, std::size_t bytesBefore) {
  std::printf("%.6g %.6g %zu\n", error.rms_mN(), bytesPerSecond, bytesBefore);
  return 0;
}

double linesPerSecond_bytes(const std::string& sent, double rate_Hz) {
  return rate_Hz * static_cast<double>(forceLine(sent).size() + forceLine("P,1000,1000000,1000000").size());
}

/// A force that is computed from a reading goes out with the next exchange.
int host(const char* file, double rate_Hz) {
  const auto program = std::make_unique<ForceProgram>(prepared(file, rate_Hz));
  ForceEngine engine(*program);
  ForceError error(*program);
  double next_s = 0, acting_N = 0, computed_N = 0;
  for (double t = 0; t < end_s; t += tick_s) {
    if (t >= next_s) {
      acting_N = computed_N;
      computed_N = engine.step({encoded_mm(t, program->step_mm), {}, true}).force_N;
      next_s += program->period_s;
    }
    error.add(t, acting_N);
  }
  return print(error, linesPerSecond_bytes("F,1000,-1000000", rate_Hz), 0);
}

int upload(const char* file, std::uint32_t rows) {
  const auto program = std::make_unique<ForceProgram>(prepared(file, 1000));
  std::size_t bytes = 0;
  firmware::setup();
  for (const std::string& line : forceTableLines(*program, rows)) {
    const std::string sent = forceLine(line);
    bytes += sent.size();
    if (!firmware::exchange(sent.substr(0, sent.size() - 1)).starts_with("A*")) return EXIT_FAILURE;
  }
  ForceError error(*program);
  const auto step_us = static_cast<std::uint32_t>(std::lround(1e6 * tick_s));
  for (double t = 0; t < end_s; t += tick_s) {
    firmware::counts = static_cast<std::int32_t>(std::floor(positionAt(t) * 1e6 / firmware::step_nm));
    firmware::lastLine_us = firmware::time_us;  // the host listens
    firmware::run(step_us);
    error.add(t, firmware::force_uN * 1e-6);
  }
  return print(error, linesPerSecond_bytes("H,1000", 1000), bytes);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "host" && argc == 4) return host(argv[2], std::atof(argv[3]));
  if (what == "upload" && argc == 4) return upload(argv[2], static_cast<std::uint32_t>(std::atoi(argv[3])));
  std::fprintf(stderr, "trade_probe host BUTTON RATE_HZ | upload BUTTON ROWS\n");
  return 2;
}
