// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/plot_rectangles.h"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

StraightLine lineOf(double from, double to, double across) { return {from, to, across, across}; }

/// A grid of 8 by 6 cells with ticks, on a card whose lower border stands close under its numbers.
LineSet gridOnACard() {
  LineSet lines;
  for (int i = 0; i <= 8; ++i) lines.vertical.push_back(lineOf(241, 436, 640 + 31.5 * i));
  for (int i = 0; i <= 6; ++i) lines.horizontal.push_back(lineOf(632, i == 6 ? 925 : 892, 241 + 31.5 * i));
  lines.horizontal.push_back(lineOf(588, 982, 152));
  lines.horizontal.push_back(lineOf(588, 982, 458));
  lines.vertical.push_back(lineOf(152, 458, 588));
  lines.vertical.push_back(lineOf(152, 458, 982));
  return lines;
}

}  // namespace

TEST_CASE("numbers whose stems meet their ticks do not draw a plot down to their feet") {
  LineSet lines = gridOnACard();
  const bool stems = GENERATE(false, true);
  if (stems)
    for (const std::size_t i : {0U, 2U, 8U}) lines.vertical[i].to = 455;
  const auto found = findPlotRectangles(lines, 60, 42);
  REQUIRE_FALSE(found.empty());
  const auto& best = *std::ranges::max_element(found, {}, &PlotRectangle::score);
  CHECK(best.box.x0 == Approx(640));
  CHECK(best.box.x1 == Approx(892));
  CHECK(best.box.y0 == Approx(241));
  CHECK(best.box.y1 == Approx(430));
}

TEST_CASE("a grid whose lines go on goes on, though a title hides two lines of three") {
  LineSet lines = gridOnACard();
  for (StraightLine& line : lines.vertical)
    if (line.from == 241) line.to = 461.5;
  for (const std::size_t i : {1U, 2U, 4U, 5U, 7U}) lines.vertical[i].to = 430;
  lines.horizontal.push_back(lineOf(640, 892, 461.5));
  const auto found = findPlotRectangles(lines, 60, 42);
  REQUIRE_FALSE(found.empty());
  const auto& best = *std::ranges::max_element(found, {}, &PlotRectangle::score);
  CHECK(best.box.y1 == Approx(461.5).margin(2));
}
