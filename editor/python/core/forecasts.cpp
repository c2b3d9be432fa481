// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/python/core/forecasts.h"

#include <charconv>
#include <utility>

#include "editor/python/core/refusal.h"
#include "importer/program/library_json.h"
#include "importer/switch_library.h"
#include "playback/offline/press_files.h"
#include "playback/offline/press_speed.h"
#include "playback/offline/standard_press.h"
#include "playback/prepare/playback_settings.h"
#include "playback/prepare/prepare_program.h"
#include "playback/program/performance_command.h"
#include "playback/study/perception/middle.h"
#include "playback/study/program/confusion_command.h"

namespace detent::python {
namespace {

/// A JSON array of objects.
std::string arrayOf(const std::vector<std::string>& objects) {
  std::string text;
  for (const std::string& object : objects) text += (text.empty() ? "" : ",") + object;
  return "[" + text + "]";
}

/// All digits of a number, so that it reads back bit for bit.
std::string numberText(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

[[noreturn]] void tooFew(const char* what, const char* needs, const char* remedy) {
  throw Refusal(Refused::from({FailureCode::wrongUsage, what, "", needs, remedy}));
}

playback::PlaybackSettings settingsOf(const std::string& feel) {
  playback::PlaybackSettings settings = playback::usualSettings();
  const auto known = playback::feels.value(feel);
  if (!known)
    throw Refusal(Refused::from(
        {FailureCode::wrongUsage, "feel", Message(feel), "is not clear or paper", "Pass one of the two"}));
  settings.feel = *known;
  return settings;
}

}  // namespace

std::vector<float> renderedPress(const Button& button, const std::string& traceFile, double rate_Hz,
                                 const std::string& feel, const Cancelled& cancelled) {
  const playback::PlaybackSettings felt = settingsOf(feel);
  const auto prepared = valueOf(playback::prepareProgram(button, {}, felt));
  const auto trace = traceFile.empty() ? playback::standardPress(prepared.program)
                                       : valueOf(playback::readPressTrace(traceFile));
  playback::RenderSettings settings;
  settings.sampleRate_Hz = rate_Hz;
  settings.cancelled = cancelled;
  valueOf(playback::checkRendering(trace, settings));
  const auto pressed = valueOf(playback::asPressed(button, prepared, trace, {}, felt));
  return valueOf(playback::renderPress(pressed.prepared.program, trace, settings)).samples;
}

std::string confusionOf(const std::vector<Button>& buttons, const Cancelled& cancelled) {
  if (buttons.size() < 2) tooFew("confusion", "needs two buttons or more", "Pass those to be told apart");
  std::vector<playback::FeltButton> felt;
  for (const Button& button : buttons) felt.push_back(valueOf(playback::feel(button, {}, cancelled)));
  const auto pairs = playback::predictAll(felt, [&](std::size_t, std::size_t) { return !cancelled(); });
  if (pairs.empty()) throw Refusal(Refused::from(Failure::cancelled("confusion")));
  const auto ranks = playback::ranksOf(pairs);
  std::vector<std::string> list;
  std::size_t at = 0;
  for (std::size_t second = 1; second < felt.size(); ++second) {
    for (std::size_t first = 0; first < second; ++first, ++at) {
      list.push_back(playback::pairJson(std::to_string(first), std::to_string(second), pairs[at], ranks[at]));
    }
  }
  return arrayOf(list);
}

std::string performanceOf(const std::vector<Button>& buttons, const std::optional<double>& operateAt_mm,
                          const Cancelled& cancelled) {
  if (buttons.empty()) tooFew("performance", "needs a button", "Give one button or more");
  playback::ForecastSettings settings;
  settings.operateAt_mm = operateAt_mm;
  std::vector<std::string> list;
  for (const Button& button : buttons) {
    const auto forecast = playback::forecastPress(button, settings, cancelled);
    if (!forecast) throw Refusal(Refused::from(Failure::cancelled("performance")));
    list.push_back(playback::buttonJson(*forecast));
  }
  return arrayOf(list);
}

std::pair<Button, std::string> buttonBetween(const Button& from, const Button& to,
                                             const std::optional<double>& share, const Cancelled& cancelled) {
  auto place = valueOf(share ? playback::placeBetween(from, to, *share, cancelled)
                             : playback::perceptualMiddle(from, to, {}, {}, cancelled));
  std::string json = "{\"share\":" + numberText(place.share) +
                     ",\"d_prime_from\":" + numberText(place.dPrimeFrom) +
                     ",\"d_prime_to\":" + numberText(place.dPrimeTo) +
                     ",\"equal_halves\":" + (place.equal() ? "true}" : "false}");
  return {std::move(place.button), std::move(json)};
}

std::string switchesLike(const Button& button, const std::string& database, std::size_t limit) {
  importer::FindRequest request;
  request.database = database;
  request.limit = limit;
  request.like = importer::feltShapeOf(button.states().front().graph);
  if (!request.like)
    throw Refusal(Refused::from({FailureCode::noForceGraph, button.name(), "press stroke",
                                 "it ends where it first resists", "Check that it holds a whole press"}));
  return importer::foundJson(valueOf(importer::findSwitches(request)));
}

}  // namespace detent::python
