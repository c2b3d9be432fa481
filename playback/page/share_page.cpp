// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/page/share_page.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/key_figures.h"
#include "model/speed_family.h"
#include "model/version.h"
#include "playback/offline/standard_press.h"
#include "playback/page/button_numbers.h"
#include "playback/page/page_parts.h"
#include "playback/prepare/prepare_program.h"

namespace detent::playback {

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostButtons = 9;      // one digit key each
constexpr std::size_t pointsOfCurve = 240;  // half a pixel of the page's graph

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < here ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text.push_back(k <= here ? digits[group >> (18 - 6 * k) & 63] : '=');
  }
  return text;
}

/// Little-endian, as WebAssembly and every browser's Float64Array on the machines it runs on have it.
std::string bytesOf(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double number : numbers)
    for (unsigned shift = 0; shift < 64; shift += 8)
      bytes.push_back(static_cast<char>(std::bit_cast<std::uint64_t>(number) >> shift & 0xFF));
  return bytes;
}

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

/// All of them, without a value where the button has none: a page's rows stand in one order whatever is in
/// it.
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
                 {"numbers", base64(bytesOf(numbersOf(button)))},
                 {"fullPress_N", standardPeak_N(prepared->program)},
                 {"states", states},
                 {"figures", figuresOf(button.states().front())}};
  if (const std::vector<double> speeds = speedsOf(button); !speeds.empty()) {
    described["speeds_mm_per_s"] = speeds;
    described["drawn_mm_per_s"] = *button.states().front().speed_mm_per_s;
  }
  return described;
}

/// JSON that cannot end the element it stands in, whatever a button is called; bytes that are no UTF-8 become
/// U+FFFD.
std::string insideScript(const Json& json) {
  std::string text;
  for (const char c : jsonText(json)) {
    if (c == '<')
      text += "\\u003c";
    else
      text.push_back(c);
  }
  return text;
}

std::string insideElement(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return escaped;
}

/// The template with every @NAME@ replaced, in one pass: what is put in is not looked at.
std::string filled(std::string_view html,
                   const std::vector<std::pair<std::string_view, std::string>>& parts) {
  std::string page;
  while (!html.empty()) {
    const std::size_t at = html.find('@');
    page += html.substr(0, at);
    if (at == std::string_view::npos) break;
    html.remove_prefix(at);
    const auto part =
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return html.starts_with(p.first); });
    if (part == parts.end()) {
      page += '@';
      html.remove_prefix(1);
    } else {
      page += part->second;
      html.remove_prefix(part->first.size());
    }
  }
  return page;
}

Failure unusable(Message problem, const Message& remedy) {
  return {FailureCode::wrongUsage, "page", {}, std::move(problem), remedy};
}

}  // namespace

bool hasPageEngine() { return !page_parts::engine.empty(); }

Result<std::string> sharePage(const std::vector<Button>& buttons) {
  if (!hasPageEngine())
    return unusable(Message("this build of Detent has no engine for browsers"),
                    Message("Install clang-14, lld-14, wasi-libc, libc++-14-dev-wasm32 and "
                            "libclang-rt-14-dev-wasm32, then configure and build anew"));
  if (buttons.empty() || buttons.size() > mostButtons)
    return unusable(Message("a page holds 1 to %1 buttons, not %2", mostButtons, buttons.size()),
                    Message("Name fewer buttons, or make several pages"));
  Json list = Json::array();
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    Result<Json> button = described(buttons[i], i);
    if (!button) return button.failure();
    list.push_back(std::move(*button));
  }
  const std::string title = insideScript(
      buttons.size() == 1 ? list[0]["name"] : Json(std::to_string(buttons.size()) + " buttons to press"));
  const Json data{{"title", Json::parse(title)}, {"buttons", list}, {"engine", base64(page_parts::engine)}};
  const std::string engineScript(page_parts::engineScript);
  return filled(page_parts::html, {{"@TITLE@", insideElement(data["title"].get<std::string>())},
                                   {"@STYLE@", std::string(page_parts::style)},
                                   {"@VERSION@", version()},
                                   {"@FEEL@", std::string(feels.word(usualSettings().feel))},
                                   {"@DATA@", insideScript(data)},
                                   {"@ENGINE@", engineScript},
                                   {"@WORKLET@", engineScript + std::string(page_parts::worklet)},
                                   {"@SCRIPT@", std::string(page_parts::script)}});
}

}  // namespace detent::playback
