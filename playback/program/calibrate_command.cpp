// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/calibrate_command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/number_table.h"
#include "model/program/command_line.h"
#include "playback/measurement/calibrate.h"
#include "playback/measurement/profile_file.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"
#include "playback/program/shared_options.h"

namespace detent::playback {

namespace {

struct CalibrateArguments {
  SensorOptions sensor;
  std::string weightsFile;
  CalibrationSettings calibration;
  std::string outputFile;
  bool json = false;
};

constexpr double weighing_s = 1.0;
constexpr double largestSd_counts = 3,
                 largestSdOfMean = 0.02;  // limits above which a weighing is reported as noisy

void addCalibrateOptions(CLI::App& app, CalibrateArguments& a) {
  addSensorOptions(app, a.sensor);
  app.add_option("--weights", a.weightsFile,
                 "Known weights as CSV: mass_g,raw or force_N,raw; default: the program asks for them");
  addChoice(app, "--circuit", a.calibration.circuit, sensorCircuits, "Circuit of the sensor", "divider");
  app.add_option("--full-scale", a.calibration.fullScale_counts, "Largest reading of the converter")
      ->capture_default_str()
      ->check(numberWithin(1, 1e9));
  app.add_option("--degree", a.calibration.highestDegree, "Highest degree of the curve")
      ->capture_default_str()
      ->check(numberWithin(1, 3));
  app.add_option("-o,--output", a.outputFile, "Device profile to write; an existing one keeps its response")
      ->required();
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

/// "20", "20.5 g", "20,5", "0.05 kg" in grams; empty for any other text.
std::optional<double> massIn_g(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  double mass = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), mass);
  if (error != std::errc() || !std::isfinite(mass) || mass < 0) return {};
  std::string unit(end, static_cast<const char*>(text.data() + text.size()));
  std::erase_if(unit, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
  if (unit.empty() || unit == "g") return mass;
  if (unit == "kg") return 1000 * mass;
  return {};
}

/// Reports one weighing to the user.
void reportCalibration(const KnownWeight& weight, const RawReading& raw) {
  std::fprintf(stderr, "%.4f N: %.2f, SD %.2f over %zu readings\n", weight.force_N, raw.mean, raw.sd, raw.n);
  if (!raw.steady)
    std::fprintf(stderr, "warning: the reading still drifts; let the weight settle and weigh it again\n");
  if (raw.sd > largestSd_counts && raw.sd > largestSdOfMean * std::fabs(raw.mean))
    std::fprintf(stderr, "warning: SD %.2f is much; put the sensor on something firm, check its wiring\n",
                 raw.sd);
}

struct Weighings {
  std::vector<KnownWeight> weights;
  /// standard deviations of the raw readings; as many as weights if they were measured
  std::vector<double> sds;
};

/// Asks the person at the terminal for weights: one mass per line, until an empty line or the end of input.
Result<Weighings> askForWeights(const CalibrateArguments& a, const Cancelled& cancelled) {
  Weighings weighings;
  std::fprintf(stderr,
               "Lay a weight on the sensor, type its mass in g, Enter. 0 for none. An empty line ends.\n");
  for (std::string line; !cancelled() && std::getline(std::cin, line) && !line.empty();) {
    const std::optional<double> mass_g = massIn_g(line);
    if (!mass_g) {
      std::fprintf(stderr, "\"%s\" is no mass; type for example 50, 20.5 g or 0.05 kg\n", line.c_str());
      continue;
    }
    KnownWeight w;
    w.force_N = 1e-3 * *mass_g * standardGravity_m_per_s2;
    Result<RawReading> raw = readRawSensor(a.sensor.port, a.sensor.baud, weighing_s, cancelled);
    if (!raw) return raw.failure();
    w.raw = raw->mean;
    reportCalibration(w, *raw);
    weighings.weights.push_back(w);
    weighings.sds.push_back(raw->sd);
  }
  return weighings;
}

/// Noise in newtons: the median over the weights of the readings' SD; 0 if it was not measured.
double noiseOf(const Weighings& weighings, const SensorCalibration& calibration) {
  std::vector<double> noises_N;
  for (std::size_t i = 0; i < weighings.sds.size(); ++i) {
    const double raw = weighings.weights[i].raw;
    const double noise_N =
        std::fabs(calibration.force_N(raw + weighings.sds[i]) - calibration.force_N(raw - weighings.sds[i])) /
        2;
    if (std::isfinite(noise_N)) noises_N.push_back(noise_N);
  }
  if (noises_N.empty()) return 0;
  std::nth_element(noises_N.begin(), noises_N.begin() + static_cast<long>(noises_N.size() / 2),
                   noises_N.end());
  return noises_N[noises_N.size() / 2];
}

int runCalibrate(const CalibrateArguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileToExtend(a.outputFile);
  if (!profile) return fail(profile.failure());
  Weighings weighings;
  if (a.weightsFile.empty()) {
    Result<Weighings> typedWeights = askForWeights(a, cancelled);
    if (!typedWeights) return fail(typedWeights.failure());
    weighings = *std::move(typedWeights);
  } else {
    constexpr std::size_t largest_bytes = 1U << 20;
    const auto text = readTable(a.weightsFile, largest_bytes, "Give a CSV of known weights");
    if (!text) return fail(text.failure());
    Result<std::vector<KnownWeight>> weights = parseWeights(*text, a.weightsFile);
    if (!weights) return fail(weights.failure());
    weighings.weights = *std::move(weights);
  }
  if (cancelled()) return fail(Failure::cancelled("calibrate"));
  Result<SensorCalibration> calibration = calibrate(weighings.weights, a.calibration);
  if (!calibration) return fail(calibration.failure());
  calibration->noise_N = noiseOf(weighings, *calibration);
  profile->sensor = *calibration;
  if (Result<Done> w = writeDeviceProfile(*profile, a.outputFile); !w) return fail(w.failure());
  Json coefficients = Json::array(), errors = Json::array();
  for (std::size_t i = 0; i < calibration->coefficientCount; ++i) {
    std::fprintf(stderr, "c%zu = %.6g +- %.2g\n", i, calibration->coefficients[i],
                 calibration->standardErrors[i]);
    coefficients.push_back(calibration->coefficients[i]);
    errors.push_back(calibration->standardErrors[i]);
  }
  for (const KnownWeight& w : weighings.weights) {
    std::fprintf(stderr, "%.4f N read as %.4f N, off by %+.4f N\n", w.force_N, calibration->force_N(w.raw),
                 calibration->force_N(w.raw) - w.force_N);
  }
  if (calibration->noise_N > 0) std::fprintf(stderr, "noise %.4f N\n", calibration->noise_N);
  std::fprintf(stderr, "residual %.4f N over %.3g to %.3g N, %zu weights\n", calibration->residual_N,
               calibration->lowest_N, calibration->highest_N, calibration->weights);
  if (a.json) {
    print({{"status", "ok"},
           {"profile", a.outputFile},
           {"coefficients", coefficients},
           {"standard_errors", errors},
           {"residual_N", calibration->residual_N},
           {"noise_N", calibration->noise_N},
           {"weights", calibration->weights}});
  }
  return 0;
}

}  // namespace

void addCalibrateCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand("calibrate", "Calibrate a force sensor with known weights");
  const auto arguments = std::make_shared<CalibrateArguments>();
  addCalibrateOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    if (arguments->weightsFile.empty() && arguments->sensor.port.empty())
      throw CLI::RequiredError("--weights or --sensor");
    chosen = [arguments](const Cancelled& cancelled) { return runCalibrate(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
