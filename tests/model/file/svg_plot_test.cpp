// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/svg_plot.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <catch2/catch.hpp>

#include "model/edits.h"
#include "model/sections.h"
#include "model/templates.h"

using namespace detent;

namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace

TEST_CASE("ticks are 1, 2 or 5 times a power of ten and enclose the range") {
  for (double low : {-1.0, 0.0, 0.3, 1e-9, 1e5})
    for (double width : {0.0, 1e-6, 0.37, 1.0, 3.9, 4.0, 4.1, 99.0, 1e6}) {
      const Ticks ticks = niceTicks(low, low + width, 8);
      INFO(low << " + " << width);
      CHECK(ticks.count >= 2);
      CHECK(ticks.count <= 18);
      CHECK(ticks.at(0) <= low + 1e-6 * ticks.step);
      CHECK(ticks.last() >= low + width - 1e-6 * ticks.step);
      const double mantissa = ticks.step / std::pow(10, std::floor(std::log10(ticks.step * 1.0000001)));
      CHECK((mantissa == Approx(1) || mantissa == Approx(2) || mantissa == Approx(5)));
    }
  const Ticks cherry = niceTicks(0, 4, 8);
  CHECK(cherry.step == 0.5);
  CHECK(cherry.count == 9);
  CHECK(cherry.decimals == 1);
}

TEST_CASE("a plot names its axes, units and strokes, and calls out its points") {
  SvgPlotStyle style;
  style.forceUnit = ForceUnit::centinewton;
  const std::string svg = svgFrom(*tactileButton(), style);
  CHECK_THAT(svg, Catch::Contains("Displacement (mm)") && Catch::Contains("Force (cN)"));
  CHECK_THAT(svg, Catch::Contains("55 cN at 1.3 mm"));
  CHECK(countOf(svg, "class=\"press\"") == 1);
  CHECK(countOf(svg, "class=\"release\"") == 1);
  // The dashes lie above the press: both are seen in their common bottom-out.
  CHECK(svg.find("class=\"release\"") > svg.find("class=\"press\""));
  CHECK(svg == svgFrom(*tactileButton(), style));
  style.callouts = false;
  CHECK(svgFrom(*tactileButton(), style).find("Tactile point") == std::string::npos);
}

TEST_CASE("a plot speaks the reader's language and stands in millimetres") {
  SvgPlotStyle style;
  style.words.force = "Kraft";
  style.words.preTravel = "Vorlaufweg";
  style.decimalSign = ',';
  style.dimensions = true;
  style.monochrome = true;
  style.width_mm = 88;
  style.secondForceUnit = ForceUnit::gramForce;
  const std::string svg = svgFrom(*tactileButton(), style);
  CHECK_THAT(svg,
             Catch::Contains("Kraft (N)") && Catch::Contains("Kraft (gf)") && Catch::Contains("Vorlaufweg"));
  CHECK_THAT(svg, Catch::Contains("width=\"88.00mm\"") && Catch::Contains(">0,5<"));
  CHECK_THAT(svg, !Catch::Contains("#0072b2") && !Catch::Contains(">0.5<"));
}

TEST_CASE("a band of tolerance is as wide as requested, and named") {
  SvgPlotStyle style;
  style.forceUnit = ForceUnit::centinewton;
  style.yEnds = AxisEnds{0, 200};
  const PlotFrame frame = frameOfPlot(tactileButton()->states()[0], style);
  const auto widest_px = [&](const std::string& svg) {
    const std::string marker = "class=\"tolerance\" d=\"";
    const auto from = svg.find(marker) + marker.size();
    std::istringstream path(svg.substr(from, svg.find(" Z", from) - from));
    std::vector<std::pair<double, double>> points;
    char command = 0;
    for (double x = 0, y = 0; path >> command >> x >> y;) points.emplace_back(x, y);
    REQUIRE(points.size() > 4);
    double widest = 0;  // the way back goes along the same places
    for (std::size_t i = 0; i < points.size() / 2; ++i)
      widest = std::max(widest, points[points.size() - 1 - i].second - points[i].second);
    return widest;
  };
  const double perN_px = (frame.bottom_px - frame.top_px) / 2;  // of 200 cN
  style.tolerance_N = 0.05;
  const std::string byForce = svgFrom(*tactileButton(), style);
  CHECK(widest_px(byForce) == Approx(2 * 0.05 * perN_px).margin(0.02));
  CHECK_THAT(byForce, Catch::Contains("Press \u00b1 5 cN"));
  style.tolerance = 0.1;
  const std::string byShare = svgFrom(*tactileButton(), style);
  const double largest_N = tactileButton()->states()[0].graph.press().forceRange_N().second;
  CHECK(widest_px(byShare) == Approx(2 * 0.1 * largest_N * perN_px).margin(0.05));
  CHECK_THAT(byShare, Catch::Contains("Press \u00b1 10 %"));
}

TEST_CASE("no leader crosses a name") {
  const std::string svg = svgFrom(*tactileButton());
  CHECK(svg.rfind("stroke=\"#444\"") < svg.find("fill-opacity=\"0.85\""));
}

TEST_CASE("no leader runs under the name of another point, where points are close together") {
  const auto follows = editGraph(*tactileButton(), 0,
                                 [](const ForceGraph& graph) { return mirrorPressToRelease(graph, 0.05); });
  REQUIRE(follows);
  const double valley_mm =
      tactilePoints(*follows->states()[0].graph.release(), Stroke::release).front().displacement_mm;
  for (const double behind_mm : {0.05, 0.1, 0.16, 0.2, 0.3}) {
    const auto closes = setOperatingPoint(*follows, 0, valley_mm + behind_mm + 0.08);
    REQUIRE(closes);
    const auto button = setResetPoint(*closes, 0, valley_mm + behind_mm);
    REQUIRE(button);
    std::istringstream lines(svgFrom(*button));
    std::vector<std::array<double, 4>> leaders, plates;
    for (std::string line; std::getline(lines, line);) {
      std::array<double, 4> at{};
      if (line.find("stroke=\"#444\"") != std::string::npos &&
          std::sscanf(line.c_str(), "<line x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", &at[0], &at[1],
                      &at[2], &at[3]) == 4)
        leaders.push_back(at);
      if (line.find("fill-opacity=\"0.85\"") != std::string::npos &&
          std::sscanf(line.c_str(), "<rect x=\"%lf\" y=\"%lf\" width=\"%lf\" height=\"%lf\"", &at[0], &at[1],
                      &at[2], &at[3]) == 4)
        plates.push_back(at);
    }
    REQUIRE(leaders.size() >= 4);
    REQUIRE(leaders.size() == plates.size());
    for (std::size_t i = 0; i < leaders.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)  // elements written before
        for (int k = 0; k <= 50; ++k) {
          const auto [x0, y0, x1, y1] = leaders[i];
          const double x = x0 + (x1 - x0) * k / 50, y = y0 + (y1 - y0) * k / 50;
          const auto [left, top, width, height] = plates[j];
          INFO("leader " << i << ", name " << j << ", " << behind_mm << " mm behind the valley");
          CHECK_FALSE((x > left + 0.1 && x < left + width - 0.1 && y > top + 0.1 && y < top + height - 0.1));
        }
  }
}

TEST_CASE("labels of a small plot lie over no other, and what is left out is named") {
  const auto closes = setOperatingPoint(*tactileButton(), 0, 1.1);
  REQUIRE(closes);
  const auto button = setResetPoint(*closes, 0, 0.9);
  REQUIRE(button);
  constexpr double pxPerMm = 96 / 25.4;
  const std::vector<std::array<double, 3>> cases = {
      // mm, mm, most that may be left out
      {60, 60, 5}, {80, 60, 4}, {88, 66, 4}, {100, 75, 3}, {150, 105, 0}, {254, 143, 0}};
  for (const auto& [width_mm, height_mm, most] : cases)
    for (const bool dimensions : {true, false}) {
      INFO(width_mm << " x " << height_mm << " mm, dimensions: " << dimensions);
      SvgPlotStyle style;
      style.width_px = width_mm * pxPerMm;
      style.height_px = height_mm * pxPerMm;
      style.dimensions = dimensions;
      const std::string svg = svgFrom(*button, style);
      const PlotFrame frame = frameOfPlot(button->states()[0], style);
      std::vector<std::array<double, 4>> plates;
      std::istringstream lines(svg);
      for (std::string line; std::getline(lines, line);) {
        std::array<double, 4> at{};  // left, top, width, height
        if (line.find("fill-opacity=\"0.85\"") != std::string::npos &&
            std::sscanf(line.c_str(), "<rect x=\"%lf\" y=\"%lf\" width=\"%lf\" height=\"%lf\"", &at[0],
                        &at[1], &at[2], &at[3]) == 4)
          plates.push_back(at);
      }
      for (std::size_t i = 0; i < plates.size(); ++i) {
        const auto [left, top, width, height] = plates[i];
        CHECK((left >= frame.left_px && top >= frame.top_px && top + height <= frame.bottom_px));
        CHECK(left + width <= style.width_px);
        for (std::size_t j = 0; j < i; ++j) {
          const auto [x, y, w, h] = plates[j];
          CHECK((left >= x + w - 0.1 || x >= left + width - 0.1 || top >= y + h - 0.1 ||
                 y >= top + height - 0.1));
        }
      }
      const auto missing = labelsWithoutRoom(*button, style);
      CHECK(static_cast<double>(missing.size()) <= most);
      CHECK(countOf(svg, "<circle") <= plates.size() + missing.size());
      for (const std::string& label : missing) {
        INFO(label);
        CHECK_THAT(label, Catch::Contains(" mm"));
        CHECK(svg.find(label.substr(label.find_first_of("0123456789"))) == std::string::npos);
      }
    }
}

TEST_CASE("curves end at the ends that are given, and have room behind the last tick") {
  SvgPlotStyle style;
  const double usualEnd_px = frameOfPlot(tactileButton()->states()[0], style).right_px;
  style.roomBeyondEnd = 0;
  const PlotFrame whole = frameOfPlot(tactileButton()->states()[0], style);
  style.roomBeyondEnd = 0.1;
  const PlotFrame roomy = frameOfPlot(tactileButton()->states()[0], style);
  CHECK(roomy.x.last() == whole.x.last());
  CHECK(usualEnd_px < whole.right_px - 10);  // a bottom-out is not drawn on the edge of its box
  CHECK(roomy.right_px - roomy.left_px == Approx((whole.right_px - whole.left_px) / 1.1));
  style.xEnds = AxisEnds{1, 2};
  style.yEnds = AxisEnds{0, 0.5};
  const PlotFrame part = frameOfPlot(tactileButton()->states()[0], style);
  CHECK(part.x.first == 1);
  CHECK(part.x.last() == 2);
  const std::string svg = svgFrom(*tactileButton(), style);
  const std::string marker = "class=\"press\" d=\"";
  const auto from = svg.find(marker) + marker.size();
  std::istringstream path(svg.substr(from, svg.find('"', from) - from));
  char command = 0;
  double x = 0, y = 0;
  int points = 0;
  while (path >> command >> x >> y) {
    ++points;
    CHECK(x >= part.left_px - 0.01);
    CHECK(x <= part.right_px + 0.01);
    CHECK(y >= part.top_px - 0.01);
    CHECK(y <= part.bottom_px + 0.01);
  }
  CHECK(points >= 2);
}

TEST_CASE("a box with room does not go on to a tick far behind the curves") {
  SvgPlotStyle style;
  style.width_px = 333;
  style.fontSize_px = 10;
  style.lengthUnit = LengthUnit::inch;
  style.roomBeyondEnd = 0;
  const auto button = tactileButton();
  const ButtonState& state = button->states()[0];
  const double end = state.graph.travel_mm() / millimetresPer(LengthUnit::inch);
  const PlotFrame toTheTick = frameOfPlot(state, style);
  REQUIRE(toTheTick.x.last() > 1.1 * end);
  style.roomBeyondEnd = 0.04;
  const PlotFrame roomy = frameOfPlot(state, style);
  CHECK(roomy.x.last() < end);
  CHECK(roomy.xPx(1.04 * end) == Approx(toTheTick.right_px));
  style.xEnds = AxisEnds{0, toTheTick.x.last()};  // the request is drawn
  CHECK(frameOfPlot(state, style).x.last() == toTheTick.x.last());
}

TEST_CASE("one plot per state; a missing release is not drawn") {
  CHECK(countOf(svgFrom(*selfLockingButton()), "class=\"press\"") == 2);
  const auto pressOnly = editGraph(*linearButton(), 0, [](const ForceGraph& g) { return removeRelease(g); });
  const auto free = setResetPoint(*pressOnly, 0, {});
  REQUIRE(free.ok());
  CHECK(countOf(svgFrom(*free), "class=\"release\"") == 0);
}

TEST_CASE("knots are on their pixels") {
  LinearTemplate values;
  values.endForce_N = 0.8;
  // 640 x 460: the frame runs from 74 to 616 and from 44 to 400; ticks 0..4 mm and 0..0.8 N.
  SvgPlotStyle style;
  style.roomBeyondEnd = 0;
  const std::string svg = svgFrom(*linearButton(values), style);
  CHECK_THAT(svg, Catch::Contains("d=\"M74.00 266.50 C254.67 192.33 435.33 118.17 616.00 44.00\""));
}

TEST_CASE("names cannot break the picture, extremes have numbers in it") {
  const auto hostile = rename(*linearButton(), "<script>&\"\x01");
  const std::string svg = svgFrom(*hostile);
  CHECK(svg.find("<script>") == std::string::npos);
  CHECK_THAT(svg, Catch::Contains("&lt;script&gt;&amp;&quot;"));
  for (double force : {1e-6, 1.0, 1e6})
    for (double travel : {1e-6, 1.0, 1e4}) {
      const auto scaled = scaleTravel(*scaleForce(*tactileButton(), force), travel);
      REQUIRE(scaled.ok());
      const std::string extreme = svgFrom(*scaled);
      CHECK(extreme.find("nan") == std::string::npos);
      CHECK(extreme.find("inf") == std::string::npos);
      CHECK(extreme.size() < 60000);
    }
  // All forces 0.
  const auto flat = StrokeCurve::throughPoints({{0, 0}, {1, 0}});
  const auto graph = ForceGraph::fromCurves(*flat, {});
  const auto zero = Button::fromStates("zero", {ButtonState{"", *graph, {}, {}, {}}});
  CHECK(svgFrom(*zero).find("nan") == std::string::npos);
}
