// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/xy_plot.h"

#include <cmath>
#include <string>

#include <catch2/catch.hpp>

using namespace detent::playback;

namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Position of a printed number, px; -1 if it is not printed.
double xOf(const std::string& svg, const std::string& number) {
  const std::size_t end = svg.find("text-anchor=\"middle\">" + number + "</text>");
  if (end == std::string::npos) return -1;
  return std::stod(svg.substr(svg.rfind("x=\"", end) + 3));
}

XyPlot plotOver(double from, double to, XScale scale) {
  XyPlot plot{"a < b", "x", "y", {}, {{"", "#123456", {{from, -3}, {to, 4}}}}, scale, {}};
  return plot;
}

}  // namespace

TEST_CASE("plot: decades stand equally far from each other, with 1, 2 and 5 of each") {
  const std::string svg = svgOf({plotOver(10, 1000, XScale::decades)});
  for (const char* number : {"10", "20", "50", "100", "200", "500", "1000"}) CHECK(xOf(svg, number) > 0);
  CHECK(xOf(svg, "5") < 0);
  CHECK(xOf(svg, "2000") < 0);
  CHECK(std::abs((xOf(svg, "100") - xOf(svg, "10")) - (xOf(svg, "1000") - xOf(svg, "100"))) < 0.02);
  CHECK(xOf(svg, "1000") == 620);
  CHECK(xOf(svgOf({plotOver(10, 1000, XScale::even)}), "20") < 0);
}

TEST_CASE("plot: decades below one keep their digits") {
  const std::string svg = svgOf({plotOver(0.02, 3, XScale::decades)});
  CHECK(xOf(svg, "0.02") > 0);
  CHECK(xOf(svg, "2.00") > 0);
}

TEST_CASE("plot: marks are named where they are, words are text") {
  XyPlot plot = plotOver(10, 1000, XScale::decades);
  plot.marks = {{100, "100 Hz & more"}};
  const std::string svg = svgOf({plot});
  CHECK(xOf(svg, "100 Hz &amp; more") == xOf(svg, "100"));
  CHECK(countOf(svg, "stroke-dasharray=\"3 3\"") == 1);
  CHECK(svg.find("a &lt; b") != std::string::npos);
}
