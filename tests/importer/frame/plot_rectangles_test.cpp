// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/plot_rectangles.h"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

StraightLine lineOf(double from, double to, double across) { return {from, to, across, across}; }

/// A grid of 8 by 6 cells with ticks.
LineSet gridWithTicks() {
  LineSet lines;
  for (int i = 0; i <= 8; ++i) lines.vertical.push_back(lineOf(241, 436, 640 + 31.5 * i));
  for (int i = 0; i <= 6; ++i) lines.horizontal.push_back(lineOf(632, i == 6 ? 925 : 892, 241 + 31.5 * i));
  return lines;
}

PlotRectangle bestOf(const LineSet& lines) {
  const auto found = findPlotRectangles(lines, 60, 42);
  REQUIRE_FALSE(found.empty());
  return *std::ranges::max_element(found, {}, &PlotRectangle::score);
}

}  // namespace

TEST_CASE("numbers whose stems meet their ticks do not extend a plot down to their lower edges") {
  LineSet lines = gridWithTicks();
  // On a card whose lower border stands close under the numbers.
  for (const double y : {152.0, 458.0}) lines.horizontal.push_back(lineOf(588, 982, y));
  for (const double x : {588.0, 982.0}) lines.vertical.push_back(lineOf(152, 458, x));
  const bool stems = GENERATE(false, true);
  if (stems)
    for (const std::size_t i : {0U, 2U, 8U}) lines.vertical[i].to = 455;
  const Box box = bestOf(lines).box;
  CHECK(box.x0 == Approx(640));
  CHECK(box.x1 == Approx(892));
  CHECK(box.y0 == Approx(241));
  CHECK(box.y1 == Approx(430));
}

TEST_CASE("a grid of which a few lines go on by far below is not cut where they are fewer") {
  LineSet lines = gridWithTicks();
  for (int i = 1; i <= 3; ++i) lines.horizontal.push_back(lineOf(640, 892, 430 + 31.5 * i));
  for (std::size_t i = 0; i <= 8; ++i) lines.vertical[i].to = i == 3 || i == 6 ? 524.5 : 430;
  CHECK(bestOf(lines).box.y1 >= 493);
}
