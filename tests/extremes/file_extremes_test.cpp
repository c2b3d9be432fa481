// SPDX-License-Identifier: GPL-3.0-or-later
// Buttons of any size through every file format, and files of any text.

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

#include "model/compare.h"
#include "model/edits.h"
#include "model/file/button_file.h"
#include "model/file/curve_csv.h"
#include "model/file/graph_report.h"
#include "model/file/svg_plot.h"
#include "model/validation.h"
#include "tests/extremes/extreme_values.h"

using namespace detent;
using namespace detent::tests;

namespace {

/// No "nan" or "inf" stands in it as a number.
bool holdsOnlyNumbers(const std::string& text) {
  for (const char* wrong : {">nan", ">-nan", ">inf", ">-inf", "\"nan", "\"-nan", "\"inf\"", "\"-inf", ":nan",
                            ": nan", ",nan", ",inf", ",-inf", " nan", " -nan", " inf", " -inf"})
    if (text.find(wrong) != std::string::npos) return false;
  return true;
}

/// A text with some bytes changed, taken out or doubled.
std::string damaged(std::string text) {
  for (int i = count(1, 6); i > 0 && !text.empty(); --i) {
    const auto at = anyOf<std::size_t>(0, text.size() - 1);
    if (oneIn(3))
      text.erase(at, static_cast<std::size_t>(count(1, 20)));
    else if (oneIn(2))
      text[at] = "0123456789eE+-.,\"{}[]:nai \n"[static_cast<std::size_t>(count(0, 26))];
    else
      text.insert(at, text.substr(at, static_cast<std::size_t>(count(1, 20))));
  }
  return text;
}

}  // namespace

TEST_CASE("a button of any size survives its file bit for bit", "[finite]") {
  holdsAlways("jsonFrom, buttonFromJson", [] {
    const Button button = extremeButton();
    const auto again = buttonFromJson(jsonFrom(button), "extreme");
    if (!again) RC_FAIL(again.failure().sentence());
    RC_ASSERT(*again == button);
  });
  holdsAlways("csvFrom, graphFromCsv: the same within a thousandth of the span", [] {
    const ForceGraph graph = extremeGraph();
    const auto again = graphFromCsv(csvFrom(graph), "extreme");
    if (!again) RC_FAIL(again.failure().sentence());
    const auto distance = compare(polylinesOf(graph), polylinesOf(*again));
    RC_ASSERT(distance.ok());
    RC_ASSERT(distance->maxOfSpan < 1e-3);
  });
  holdsAlways("svgFrom", [] { RC_ASSERT(holdsOnlyNumbers(svgFrom(extremeButton()))); });
  holdsAlways("reports", [] {
    const Button button = extremeButton();
    for (const Report& report : {showReport(button, "a"), checkReport(button, validate(button), "a")}) {
      RC_ASSERT(holdsOnlyNumbers(report.json));
      RC_ASSERT(holdsOnlyNumbers(report.text));
    }
  });
}

TEST_CASE("drawn forces at the bottom of the number range have an axis") {
  for (const double force_N : {5e-324, 1e-310, 1e-300, 1e-30}) {
    CAPTURE(force_N);
    const auto press = StrokeCurve::throughPoints({{0, 0}, {2, force_N}, {4, 0}});
    REQUIRE(press);
    const auto button =
        Button::fromStates("faint", {ButtonState{"", *ForceGraph::fromCurves(*press, {}), {}, {}, {}}});
    REQUIRE(button);
    CHECK(holdsOnlyNumbers(svgFrom(*button)));
  }
}

TEST_CASE("of thousands of tactile points a plot names at most the twelve most prominent, at once") {
  std::vector<CurvePoint> zigzag;
  for (int i = 0; i < 4000; ++i) zigzag.push_back({0.001 * i, 0.5 + (i % 2 ? 0.4 + 1e-5 * i : 0)});
  const auto button = Button::fromStates(
      "rough",
      {ButtonState{"", *ForceGraph::fromCurves(*StrokeCurve::throughPoints(zigzag), {}), {}, {}, {}}});
  REQUIRE(button);
  const std::string svg = svgFrom(*button);
  std::size_t callouts = 0;
  for (std::size_t at = svg.find(">Tactile point<"); at != std::string::npos;
       at = svg.find(">Tactile point<", at + 1))
    ++callouts;
  CHECK(callouts > 4);  // as many as have room
  CHECK(callouts <= 12);
}

TEST_CASE("any text is a button, a curve, or a failure that says where") {
  holdsAlways("buttonFromJson, damaged", [] {
    const auto button = buttonFromJson(damaged(jsonFrom(extremeButton({4, 1}))), "damaged");
    if (!button) assertNamed(button.failure());
  });
  holdsAlways("graphFromCsv, damaged", [] {
    const auto graph = graphFromCsv(damaged(csvFrom(extremeGraph({4, 1}))), "damaged");
    if (!graph) assertNamed(graph.failure());
  });
  holdsAlways("graphFromCsv, any numbers", [] {
    std::string text = "stroke,displacement_mm,force_N\n";
    for (int i = count(0, 12); i > 0; --i)
      text += std::string(oneIn(3) ? "release" : "press") + "," + std::to_string(anyDouble()) + "," +
              std::to_string(anyDouble()) + "\n";
    const auto graph = graphFromCsv(text, "any");
    if (!graph) assertNamed(graph.failure());
  });
  holdsAlways("niceTicks enclose their range in few steps", [] {
    const double low = within(-1, 1) * magnitude(1e-300, 1e300);
    const double high = oneIn(8) ? low : low + magnitude(1e-12, 10) * std::abs(low);
    RC_PRE(std::isfinite(high));
    const Ticks ticks = niceTicks(low, high, count(2, 12));
    RC_ASSERT(ticks.count >= 2);
    RC_ASSERT(std::isfinite(ticks.first) && std::isfinite(ticks.last()));
    RC_ASSERT(ticks.last() > ticks.first);
  });
}
