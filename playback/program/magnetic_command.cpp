// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/magnetic_command.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/file/button_file.h"
#include "model/file/text_file.h"
#include "playback/magnetic/write_key_tables.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"

namespace detent::playback {

namespace {

struct MagneticArguments {
  std::string button, readingsFile, outputFile;
  double noise = usualNoise, scan_ms = 1;
  std::optional<double> operateAt_mm, resetAt_mm, rapid_mm, rapidRelease_mm;
  double topDeadZone_mm = 0, bottomDeadZone_mm = 0;
  bool continuous = false, json = false;
};

Failure usage(const char* option, Message problem, Remedies remedies) {
  return {FailureCode::wrongUsage, Subject::option(option), "", std::move(problem), std::move(remedies)};
}

Result<MagneticKeySettings> settingsOf(const MagneticArguments& a, const Button& button) {
  const ButtonState& state = button.states().front();
  const std::optional<double> actuate_mm = a.operateAt_mm ? a.operateAt_mm : state.operatingPoint_mm;
  if (!actuate_mm)
    return usage("--operate-at", "is missing, and the button names no operating point",
                 "Pass --operate-at MM");
  MagneticKeySettings settings = settingsFor(state, *actuate_mm);
  if (a.resetAt_mm) settings.reset_mm = *a.resetAt_mm;
  if (a.rapid_mm)
    settings.rapid = RapidTrigger{*a.rapid_mm, a.rapidRelease_mm.value_or(*a.rapid_mm), a.continuous};
  settings.topDeadZone_mm = a.topDeadZone_mm;
  settings.bottomDeadZone_mm = a.bottomDeadZone_mm;
  settings.scan_s = a.scan_ms / 1000;
  if (const Result<Done> possible = checked(settings); !possible) return possible.failure();
  return settings;
}

Result<MagneticSensor> sensorOf(const MagneticArguments& a, const Button& button) {
  if (!a.readingsFile.empty()) return MagneticSensor::fromCsv(a.readingsFile, a.noise);
  return MagneticSensor::assumed(button.states().front().graph.travel_mm(), a.noise);
}

/// The requested settings, then variants without rapid trigger and with one distance for both directions in
/// steps; the rest as requested.
std::vector<MagneticKeySettings> variantsOf(const MagneticKeySettings& chosen) {
  std::vector<MagneticKeySettings> variants = {chosen};
  const bool continuous = chosen.rapid && chosen.rapid->continuous;
  for (const double rapid_mm : {0.0, 0.1, 0.2, 0.3, 0.5, 1.0}) {
    std::optional<RapidTrigger> rapid;
    if (rapid_mm > 0) rapid = RapidTrigger{rapid_mm, rapid_mm, continuous};
    if (rapid == chosen.rapid) continue;
    variants.push_back(chosen);
    variants.back().rapid = rapid;
  }
  return variants;
}

void sayMagnetic(const MagneticKeyForecast& f) {
  std::fprintf(stderr, "  %-14s %8.1f %8.1f %14.0f %14.0f\n", textOf(f.settings.rapid).c_str(),
               f.lost_per_1000, f.doubled_per_1000, f.letsGo_per_minute, f.letsGoShallow_per_minute);
}

Json jsonOf(const MagneticKeyForecast& f) {
  const auto& rapid = f.settings.rapid;
  Json json = {{"rapid_trigger_mm", rapid ? Json(rapid->press_mm) : Json(nullptr)}};
  if (rapid && f.settings.beyondOneDistance()) {
    json["rapid_release_mm"] = rapid->release_mm;
    json["continuous"] = rapid->continuous;
  }
  json["lost_per_1000"] = f.lost_per_1000;
  json["doubled_per_1000"] = f.doubled_per_1000;
  json["lets_go_per_minute"] = f.letsGo_per_minute;
  json["lets_go_shallow_per_minute"] = f.letsGoShallow_per_minute;
  return json;
}

Result<Done> write(const MagneticArguments& a, const Button& button, const MagneticSensor& sensor,
                   const std::vector<MagneticKeyForecast>& simulated) {
  if (a.outputFile.empty()) return Done{};
  const std::string text = a.outputFile.ends_with(".csv")
                               ? sensorCsvFrom(sensor, button.states().front().graph.travel_mm())
                               : keyHeaderFrom(button, sensor, simulated.front().settings, simulated);
  return writeTextFileAtomically(a.outputFile, text);
}

void reportMagnetic(const MagneticArguments& a, const Button& button, const MagneticSensor& sensor,
                    const std::vector<MagneticKeyForecast>& simulated) {
  const MagneticKeySettings& chosen = simulated.front().settings;
  std::fprintf(
      stderr, "%s: acts at %.4g mm, resets at %.4g mm; forecast of %d presses, %s\n", button.name().c_str(),
      chosen.actuate_mm, chosen.reset_mm, fingerCount * pressesOfFinger,
      sensor.isAssumed() ? "readings assumed (pass your own with --readings)" : "readings as measured");
  std::fprintf(
      stderr,
      "  rapid trigger   lost and doubled of 1,000; held at the end, and shallow: lets go a minute\n");
  for (const MagneticKeyForecast& one : simulated) sayMagnetic(one);
  if (!a.json) return;
  Json list = Json::array();
  for (const MagneticKeyForecast& one : simulated) list.push_back(jsonOf(one));
  const TravelTable table = travelTableOf(sensor, button.states().front().graph.travel_mm());
  Json json = {{"forecast", true},
               {"readings", sensor.isAssumed() ? "assumed" : "measured"},
               {"operating_point_mm", chosen.actuate_mm},
               {"reset_point_mm", chosen.reset_mm},
               {"reading_at_rest", table.restReading},
               {"reading_at_end", table.endReading},
               {"table_error_mm", table.worst_mm},
               {"settings", std::move(list)},
               {"output", a.outputFile.empty() ? Json(nullptr) : Json(a.outputFile)}};
  if (chosen.beyondOneDistance()) {
    json["top_dead_zone_mm"] = chosen.topDeadZone_mm;
    json["bottom_dead_zone_mm"] = chosen.bottomDeadZone_mm;
  }
  print(json);
}

int runMagnetic(const MagneticArguments& a, const Cancelled& cancelled) {
  if (!a.outputFile.empty() && !a.outputFile.ends_with(".csv") && !a.outputFile.ends_with(".h"))
    return fail(usage("--output", "ends neither in .csv nor in .h", "Give the file one of these endings"));
  Result<Button> button = readButtonFile(a.button);
  if (!button) return fail(button.failure());
  const Result<MagneticKeySettings> chosen = settingsOf(a, *button);
  if (!chosen) return fail(chosen.failure());
  const Result<MagneticSensor> sensor = sensorOf(a, *button);
  if (!sensor) return fail(sensor.failure());
  const auto presses = PressedDepths::of(*button, chosen->actuate_mm, cancelled);
  if (!presses) return fail(Failure::cancelled("magnetic"));
  if (!*presses) return fail(presses->failure());
  std::vector<MagneticKeyForecast> simulated;
  for (const MagneticKeySettings& settings : variantsOf(*chosen)) {
    if (cancelled && cancelled()) return fail(Failure::cancelled("magnetic"));
    simulated.push_back(forecastKey(**presses, *button, *sensor, settings));
  }
  const Result<Done> written = write(a, *button, *sensor, simulated);
  if (!written) return fail(written.failure());
  reportMagnetic(a, *button, *sensor, simulated);
  return 0;
}

void addMagneticOptions(CLI::App& app, MagneticArguments& a) {
  app.add_option("BUTTON", a.button, "*.button.json")->required();
  app.add_option(
      "-o,--output", a.outputFile,
      "OUT.csv: readings along the travel; OUT.h: C table from reading to travel, with the settings");
  app.add_option("--readings", a.readingsFile,
                 "CSV of your sensor, displacement_mm,reading (default: an assumed magnet of usual size)");
  app.add_option("--noise", a.noise, "Standard deviation of a reading at rest, counts")
      ->check(numberWithin(0, 1e6))
      ->capture_default_str();
  app.add_option("--operate-at", a.operateAt_mm,
                 "Actuation point, mm (default: the button's operating point)")
      ->check(numberWithin(0, 1e5));
  app.add_option("--reset-at", a.resetAt_mm,
                 "Release point, mm (default: at the distance of the button's reset point)")
      ->check(numberWithin(0, 1e5));
  CLI::Option* rapid =
      app.add_option("--rapid-trigger", a.rapid_mm,
                     "Release this far above the deepest point and actuate this far below the highest, mm "
                     "(default: off)")
          ->check(numberWithin(0.001, 100));
  app.add_option("--rapid-release", a.rapidRelease_mm,
                 "Release this far above the deepest point instead, mm (default: as --rapid-trigger)")
      ->check(numberWithin(0.001, 100))
      ->needs(rapid);
  app.add_flag("--continuous", a.continuous,
               "Keep rapid trigger until the key is fully released (default: until the release point)")
      ->needs(rapid);
  app.add_option("--top-dead-zone", a.topDeadZone_mm,
                 "Keep the key released in the first part of the travel, mm")
      ->check(numberWithin(0, 100))
      ->capture_default_str();
  app.add_option("--bottom-dead-zone", a.bottomDeadZone_mm,
                 "Keep the key actuated in the last part of the travel, mm")
      ->check(numberWithin(0, 100))
      ->capture_default_str();
  app.add_option("--scan-ms", a.scan_ms, "Time between two readings, ms")
      ->check(numberWithin(0.05, 100))
      ->capture_default_str();
  app.add_flag("--json", a.json, "One JSON object on stdout");
}

}  // namespace

void addMagneticCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand(
      "magnetic", "Write settings for a magnetic keyboard's firmware and try them on simulated presses");
  const auto a = std::make_shared<MagneticArguments>();
  addMagneticOptions(*app, *a);
  app->callback(
      [&chosen, a] { chosen = [a](const Cancelled& cancelled) { return runMagnetic(*a, cancelled); }; });
}

}  // namespace detent::playback
