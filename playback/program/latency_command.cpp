// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/latency_command.h"

#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "model/file/text_file.h"
#include "playback/measurement/latency_statistics.h"
#include "playback/measurement/profile_file.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"
#include "playback/program/shared_options.h"

namespace detent::playback {

namespace {

struct LatencyArguments {
  PlayerSettings player;
  SensorOptions sensor;
  std::string inputDevice;
  std::size_t trials = 50;
  EventPlacement placement = EventPlacement::timeStamped;
  double sensorRate_Hz = 425;  ///< reading rate of the simulated sensor
  double threshold = 0;
  std::string profileFile, outputFile, csvFile;
  bool json = false;
};

constexpr int histogramBins = 12;

void addLatencyOptions(CLI::App& app, LatencyArguments& a) {
  addDeviceOptions(app, a.player);
  addSensorOptions(app, a.sensor);
  app.add_option("--input", a.inputDevice,
                 "Input that records the vibration; default: the device's own input");
  app.add_option("--trials", a.trials, "Round trips")->capture_default_str()->check(numberWithin(1, 100000));
  addPlacementOption(app, a.placement);
  app.add_option("--sensor-hz", a.sensorRate_Hz, "Rate of the simulated sensor in Hz")
      ->capture_default_str()
      ->check(numberWithin(20, 20000));
  app.add_option("--threshold", a.threshold,
                 "Onset on the input, share of full scale; 0: eight times the noise")
      ->capture_default_str()
      ->check(numberWithin(0, 1));
  app.add_option("--profile", a.profileFile, "Sensor calibration; also gets the result with --output");
  app.add_option("-o,--output", a.outputFile, "Write the result into this device profile");
  app.add_option("--csv", a.csvFile, "Every delay as CSV");
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

int runLatency(const LatencyArguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileOf(a.profileFile);
  if (!profile) return fail(profile.failure());
  LatencySettings settings;
  settings.player = a.player;
  settings.inputDevice = a.inputDevice;
  settings.trials = a.trials;
  settings.placement = a.placement;
  settings.sensorRate_Hz = a.sensorRate_Hz;
  settings.sensorPort = a.sensor.port;
  settings.baud = a.sensor.baud;
  settings.calibration = profile->sensor;
  settings.threshold = a.threshold;
  if (!a.sensor.port.empty())
    std::fprintf(stderr, "Tap the sensor %zu times, firmly and briefly.\n", a.trials);
  Result<LatencyResult> result = measureLatency(
      settings, [](std::size_t done, std::size_t all) { std::fprintf(stderr, "\r%zu of %zu", done, all); },
      cancelled);
  std::fprintf(stderr, "\r");
  if (!result) return fail(result.failure());
  const LatencyStatistics s = statisticsOf(result->delays_s, result->lost);
  if (s.n == 0) {
    return fail({FailureCode::deviceTrouble, result->device, "", "no vibration came back on the input",
                 "Lead the output to the input, or name the input with --input"});
  }
  std::fprintf(
      stderr,
      "%s: mean %.3f ms (N = %zu, SD = %.3f), median %.3f, 5 %% %.3f, 95 %% %.3f, 99 %% %.3f, lost %zu\n%s",
      result->device.c_str(), 1e3 * s.mean_s, s.n, 1e3 * s.sd_s, 1e3 * s.median_s, 1e3 * s.p5_s,
      1e3 * s.p95_s, 1e3 * s.p99_s, s.lost, histogram(s, histogramBins).c_str());
  if (!a.csvFile.empty()) {
    if (Result<Done> w = writeTextFileAtomically(a.csvFile, latencyCsv(s)); !w) return fail(w.failure());
  }
  if (!a.outputFile.empty()) {
    Result<DeviceProfile> extended = profileToExtend(a.outputFile);
    if (!extended) return fail(extended.failure());
    extended->latency = s.forProfile();
    if (Result<Done> w = writeDeviceProfile(*extended, a.outputFile); !w) return fail(w.failure());
  }
  if (a.json) {
    print({{"status", "ok"},
           {"device", result->device},
           {"n", s.n},
           {"lost", s.lost},
           {"mean_s", s.mean_s},
           {"sd_s", s.sd_s},
           {"median_s", s.median_s},
           {"p5_s", s.p5_s},
           {"p95_s", s.p95_s},
           {"p99_s", s.p99_s},
           {"min_s", s.min_s},
           {"max_s", s.max_s}});
  }
  return 0;
}

}  // namespace

void addLatencyCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand("latency", "Measure the delay from force to vibration");
  const auto arguments = std::make_shared<LatencyArguments>();
  addLatencyOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    chosen = [arguments](const Cancelled& cancelled) { return runLatency(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
