// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/page/share_page.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/key_figures.h"
#include "model/speed_family.h"
#include "model/version.h"
#include "playback/offline/standard_press.h"
#include "playback/page/button_numbers.h"
#include "playback/page/page_parts.h"
#include "playback/page/page_text.h"
#include "playback/prepare/prepare_program.h"

namespace detent::playback {

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostButtons = 9;      // one digit key each
constexpr std::size_t pointsOfCurve = 240;  // half a pixel of the page's graph

/// Points of the drawn curve: evenly spaced points and every knot; vertical rises as their two points.
Json drawn(const StrokeCurve& curve) {
  std::vector<std::pair<double, double>> points;
  for (const Knot& k : curve.knots()) points.emplace_back(k.displacement_mm, k.force_N);
  for (std::size_t i = 1; i < pointsOfCurve; ++i) {
    const double x = curve.start_mm() + curve.travel_mm() * static_cast<double>(i) / pointsOfCurve;
    points.emplace_back(x, curve.force_N(x));
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  return points;
}

const char* wordOf(FigureUnit unit) {
  switch (unit) {
    case FigureUnit::mm:
      return "mm";
    case FigureUnit::N:
      return "N";
    case FigureUnit::N_per_mm:
      return "N/mm";
    case FigureUnit::mJ:
      return "mJ";
    case FigureUnit::share:
      break;
  }
  return "";
}

/// All figures, without a value if the button does not have one, so that the rows of every page have the same
/// order.
Json figuresOf(const ButtonState& state) {
  const KeyFigures values = keyFiguresOf(state);
  Json figures = Json::array();
  for (const KeyFigureName& name : keyFigureNames()) {
    Json figure{{"name", name.term}, {"unit", wordOf(name.unit)}};
    if (const auto& value = values[name.figure]) figure["value"] = *value;
    figures.push_back(std::move(figure));
  }
  return figures;
}

Result<Json> described(const Button& button, std::size_t index) {
  Result<PreparedProgram> prepared = prepareProgram(button, {}, usualSettings());
  if (!prepared) return prepared.failure();
  Json states = Json::array();
  for (const ButtonState& state : button.states())
    states.push_back({{"name", state.name},
                      {"press", drawn(state.graph.press())},
                      {"release", state.graph.release() ? drawn(*state.graph.release()) : Json::array()}});
  Json described{{"name", button.name().empty() ? "Button " + std::to_string(index + 1) : button.name()},
                 {"numbers", base64(numbersOf(button))},
                 {"fullPress_N", standardPeak_N(prepared->program)},
                 {"states", states},
                 {"figures", figuresOf(button.states().front())}};
  if (const std::vector<double> speeds = speedsOf(button); !speeds.empty()) {
    described["speeds_mm_per_s"] = speeds;
    described["drawn_mm_per_s"] = *button.states().front().speed_mm_per_s;
  }
  return described;
}

Failure unusable(Message problem, const Message& remedy) {
  return {FailureCode::wrongUsage, "page", {}, std::move(problem), remedy};
}

}  // namespace

bool hasPageEngine() { return !page_parts::engine.empty(); }

Result<std::string> sharePage(const std::vector<Button>& buttons) {
  if (!hasPageEngine())
    return unusable(
        Message("this build of Detent cannot make a web page on which buttons can be pressed"),
        Message("Install a build of Detent that can make web pages. If you build Detent yourself, first "
                "install clang-14, lld-14, wasi-libc, libc++-14-dev-wasm32 and libclang-rt-14-dev-wasm32"));
  if (buttons.empty() || buttons.size() > mostButtons)
    return unusable(
        Message("a web page can hold 1 to %1 buttons, but %2 were given", mostButtons, buttons.size()),
        Message("Name fewer buttons, or make several pages"));
  Json list = Json::array();
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    Result<Json> button = described(buttons[i], i);
    if (!button) return button.failure();
    list.push_back(std::move(*button));
  }
  const Json name =
      buttons.size() == 1 ? list[0]["name"] : Json(std::to_string(buttons.size()) + " buttons to press");
  // valid UTF-8, whatever the name contains
  const std::string title = Json::parse(jsonText(name)).get<std::string>();
  const Json data{{"title", title}, {"buttons", list}, {"engine", base64(page_parts::engine)}};
  const std::string engineScript(page_parts::engineScript);
  return filled(page_parts::html, {{"@TITLE@", insideElement(title)},
                                   {"@STYLE@", std::string(page_parts::style)},
                                   {"@VERSION@", version()},
                                   {"@FEEL@", std::string(feels.word(usualSettings().feel))},
                                   {"@DATA@", insideScript(jsonText(data))},
                                   {"@ENGINE@", engineScript},
                                   {"@WORKLET@", engineScript + std::string(page_parts::worklet)},
                                   {"@SCRIPT@", std::string(page_parts::script)}});
}

}  // namespace detent::playback
