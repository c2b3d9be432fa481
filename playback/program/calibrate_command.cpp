// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/calibrate_command.h"

#include <cstdio>
#include <fstream>
#include <iostream>
#include <locale>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "playback/program/choice_option.h"
#include "playback/program/json_output.h"
#include "playback/program/shared_options.h"
#include "playback/study/calibrate.h"
#include "playback/study/profile_file.h"

namespace detent::playback {

namespace {

const std::map<std::string, SensorCircuit> circuits{{"newtons", SensorCircuit::newtons},
                                                    {"linear", SensorCircuit::linear},
                                                    {"divider", SensorCircuit::divider}};

struct CalibrateArguments {
  SensorOptions sensor;
  std::string weightsFile;
  CalibrationSettings calibration;
  std::string outputFile;
  bool json = false;
};

constexpr double weighing_s = 1.0;

void addOptions(CLI::App& app, CalibrateArguments& a) {
  addSensorOptions(app, a.sensor);
  app.add_option("--weights", a.weightsFile,
                 "Known weights as CSV: mass_g,raw or force_N,raw; else they are asked for");
  addChoice(app, "--circuit", a.calibration.circuit, circuits, "How the sensor is wired", "divider");
  app.add_option("--full-scale", a.calibration.fullScale_counts, "Largest reading of the converter")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--degree", a.calibration.highestDegree, "Highest degree of the curve")
      ->capture_default_str()
      ->check(CLI::Range(1, 3));
  app.add_option("-o,--output", a.outputFile, "Device profile to write; an existing one keeps its response")
      ->required();
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

/// Weights from the person at the terminal: one mass in grams per line, an empty line or the end of input
/// ends.
Result<std::vector<KnownWeight>> askForWeights(const CalibrateArguments& a, const Cancelled& cancelled) {
  std::vector<KnownWeight> weights;
  std::fprintf(stderr, "Lay a weight on the sensor, type its mass in g, Enter. An empty line ends.\n");
  for (std::string line; !cancelled() && std::getline(std::cin, line) && !line.empty();) {
    KnownWeight w;
    std::istringstream text(line);
    text.imbue(std::locale::classic());
    if (!(text >> w.force_N)) {
      std::fprintf(stderr, "no number\n");
      continue;
    }
    w.force_N *= 1e-3 * standardGravity_m_per_s2;
    Result<RawReading> raw = readRawSensor(a.sensor.port, a.sensor.baud, weighing_s);
    if (!raw) return raw.failure();
    w.raw = raw->mean;
    std::fprintf(stderr, "%.4f N: %.2f, SD %.2f over %zu readings\n", w.force_N, raw->mean, raw->sd, raw->n);
    weights.push_back(w);
  }
  return weights;
}

int run(const CalibrateArguments& a, const Cancelled& cancelled) {
  Result<DeviceProfile> profile = profileToExtend(a.outputFile);
  if (!profile) return fail(profile.failure());
  Result<std::vector<KnownWeight>> weights = std::vector<KnownWeight>{};
  if (a.weightsFile.empty()) {
    weights = askForWeights(a, cancelled);
  } else {
    std::ifstream in(a.weightsFile, std::ios::binary);
    if (!in)
      return fail(
          {FailureCode::unreadableInput, a.weightsFile, "", "cannot be read", "Give a CSV of known weights"});
    std::ostringstream text;
    text << in.rdbuf();
    weights = parseWeights(text.str(), a.weightsFile);
  }
  if (!weights) return fail(weights.failure());
  Result<SensorCalibration> calibration = calibrate(*weights, a.calibration);
  if (!calibration) return fail(calibration.failure());
  profile->sensor = *calibration;
  if (Result<Done> w = writeDeviceProfile(*profile, a.outputFile); !w) return fail(w.failure());
  Json coefficients = Json::array(), errors = Json::array();
  for (std::size_t i = 0; i < calibration->coefficientCount; ++i) {
    std::fprintf(stderr, "c%zu = %.6g +- %.2g\n", i, calibration->coefficients[i],
                 calibration->standardErrors[i]);
    coefficients.push_back(calibration->coefficients[i]);
    errors.push_back(calibration->standardErrors[i]);
  }
  std::fprintf(stderr, "residual %.4f N over %.3g to %.3g N, %zu weights\n", calibration->residual_N,
               calibration->lowest_N, calibration->highest_N, calibration->weights);
  if (a.json) {
    print({{"status", "ok"},
           {"profile", a.outputFile},
           {"coefficients", coefficients},
           {"standard_errors", errors},
           {"residual_N", calibration->residual_N},
           {"weights", calibration->weights}});
  }
  return 0;
}

}  // namespace

void addCalibrateCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand("calibrate", "Calibrate a force sensor with known weights");
  const auto arguments = std::make_shared<CalibrateArguments>();
  addOptions(*app, *arguments);
  app->callback([&chosen, arguments] {
    if (arguments->weightsFile.empty() && arguments->sensor.port.empty())
      throw CLI::RequiredError("--weights or --sensor");
    chosen = [arguments](const Cancelled& cancelled) { return run(*arguments, cancelled); };
  });
}

}  // namespace detent::playback
