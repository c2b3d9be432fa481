// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/performance_command.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/edits.h"
#include "model/file/button_file.h"
#include "playback/performance/forecast.h"
#include "playback/program/json_output.h"
#include "playback/program/number_option.h"
#include "playback/program/performance_json.h"
#include "playback/program/press_effects.h"

namespace detent::playback {

namespace {

struct PerformanceArguments {
  std::vector<std::string> buttons;
  std::optional<double> operateAt_mm;
  bool json = false;
};

Result<Button> namedButton(const std::string& file) {
  Result<Button> button = readButtonFile(file);
  if (button && button->name().empty())
    return rename(*button, std::filesystem::path(file).filename().string());
  return button;
}

const char* buttonName(Claim claim) {
  switch (claim) {
    case Claim::noDifference:
      return "no_difference_forecast";
    case Claim::higher:
      return "higher";
    case Claim::lower:
      return "lower";
    case Claim::notDecided:
      return "not_decided";
    case Claim::notForecast:
      break;
  }
  return "not_forecast";
}

Json differencesOf(const PressForecast& first, const PressForecast& second) {
  Json json{{"first", first.name}, {"second", second.name}};
  for (std::size_t f = 0; f < pressFigureCount; ++f) {
    const PressDifference difference = differenceOf(first, second, static_cast<PressFigure>(f));
    const bool known = difference.claim != Claim::notForecast;
    json[pressFigureNames()[f].key] = {{"forecast", buttonName(difference.claim)},
                                       {"ratio", known ? bandJson(difference.ratio) : Json(nullptr)}};
  }
  return json;
}

void sayPerformance(const PressForecast& forecast) {
  std::fprintf(stderr, "%s: forecast", forecast.name.c_str());
  if (forecast.operatingPoint_mm)
    std::fprintf(stderr, ", acting at %.4g mm, %s", *forecast.operatingPoint_mm,
                 forecast.jumpIsFelt ? "its jump is felt" : "without a jump that is felt");
  std::fprintf(stderr, "; median of %d fingers, 5 to 95 %%\n", fingerCount);
  if (forecast.plans.empty()) {
    std::fprintf(stderr, "  no forecast: %s\n", reasonOf(forecast.why.front()));
    return;
  }
  for (std::size_t f = 0; f < pressFigureCount; ++f) {
    const char* term = pressFigureNames()[f].term;
    if (forecast.ofFingers[f].empty()) {
      std::fprintf(stderr, "  %-36s no forecast: %s\n", term, reasonOf(forecast.why[f]));
      continue;
    }
    const Band band = bandOf(forecast.ofFingers[f]);
    std::fprintf(stderr, "  %-36s %9.3g  %9.3g to %.3g\n", term, band.median, band.low, band.high);
  }
}

void sayDifferences(const PressForecast& first, const PressForecast& second) {
  std::fprintf(stderr, "%s against %s, forecast; the same finger presses both:\n", second.name.c_str(),
               first.name.c_str());
  for (std::size_t f = 0; f < pressFigureCount; ++f) {
    const PressDifference d = differenceOf(first, second, static_cast<PressFigure>(f));
    const char* term = pressFigureNames()[f].term;
    if (d.claim == Claim::notForecast || d.claim == Claim::noDifference) {
      std::fprintf(stderr, "  %-36s %s\n", term,
                   d.claim == Claim::notForecast ? "no forecast" : "no difference forecast");
      continue;
    }
    std::fprintf(stderr, "  %-36s %s: x %.3g, %.3g to %.3g\n", term,
                 d.claim == Claim::higher  ? "higher"
                 : d.claim == Claim::lower ? "lower"
                                           : "not decided",
                 d.ratio.median, d.ratio.low, d.ratio.high);
  }
}

Json allDifferences(const std::vector<PressForecast>& all) {
  Json list = Json::array();
  for (std::size_t second = 1; second < all.size(); ++second) {
    for (std::size_t first = 0; first < second; ++first) {
      sayDifferences(all[first], all[second]);
      list.push_back(differencesOf(all[first], all[second]));
    }
  }
  return list;
}

int runPerformance(const PerformanceArguments& a, const Cancelled& cancelled) {
  std::vector<Button> buttons;
  for (const std::string& file : a.buttons) {
    Result<Button> button = namedButton(file);
    if (!button) return fail(button.failure());
    buttons.push_back(*std::move(button));
  }
  std::vector<PressForecast> all;
  Json list = Json::array();
  for (const Button& button : buttons) {
    ForecastSettings settings;
    settings.operateAt_mm = a.operateAt_mm;
    std::optional<PressForecast> forecast = forecastPress(button, settings, cancelled);
    if (!forecast) return fail(Failure::cancelled("performance"));
    all.push_back(*std::move(forecast));
    sayPerformance(all.back());
    list.push_back(forecastJson(all.back()));
  }
  const Json differences = allDifferences(all);
  if (a.json)
    print({{"forecast", true},
           {"fingers", fingerCount},
           {"buttons", std::move(list)},
           {"differences", differences}});
  return 0;
}

}  // namespace

std::string buttonJson(const PressForecast& forecast) { return jsonText(forecastJson(forecast)); }

void addPerformanceCommand(CLI::App& program, Action& chosen) {
  CLI::App* app = program.add_subcommand("performance",
                                         "Research: forecast how people press; 4 of 11 published effects are "
                                         "met (docs/reference/press-forecast.md)");
  const auto a = std::make_shared<PerformanceArguments>();
  app->add_option("BUTTON", a->buttons, "*.button.json; several are compared")->required()->expected(1, 100);
  app->add_option("--operate-at", a->operateAt_mm,
                  "Assume that the contact closes here, mm; the reset point keeps its distance")
      ->check(numberWithin(0, 1e5));
  app->add_flag("--json", a->json, "One JSON object on stdout");
  app->footer(std::string("Only differences between buttons mean something: absolute numbers depend on the "
                          "body's parameters. "
                          "Published\n"
                          "effects, forecast (5 to 95 % of the fingers) and whether that is what people did "
                          "(docs/reference/press-forecast.md):\n") +
              pressEffects);
  app->callback(
      [&chosen, a] { chosen = [a](const Cancelled& cancelled) { return runPerformance(*a, cancelled); }; });
}

}  // namespace detent::playback
