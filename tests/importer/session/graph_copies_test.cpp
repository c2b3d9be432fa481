// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of one graph are separated from other switches on equal axes, and the better one is taken.

#include "importer/graph_copies.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::importer;

namespace {

AxisCalibration axes(double xMax = 4, double yMax = 120, const char* unit = "gf") {
  AxisCalibration c;
  c.x.max = xMax, c.x.unit = "mm";
  c.y.max = yMax, c.y.unit = unit;
  return c;
}

/// A tactile switch, traced at `points` places, each off by up to `noise_N`.
StrokePair pair(int points, double noise_N = 0, double bump_N = 0.15) {
  StrokePair strokes;
  strokes.release.emplace();
  for (int i = 0; i <= points; ++i) {
    const double mm = 4.0 * i / points, off = noise_N * std::sin(12.9 * i);
    const double force = 0.3 + 0.08 * mm + bump_N * std::exp(-4 * (mm - 1.2) * (mm - 1.2));
    strokes.press.points.push_back({mm, force + off});
    strokes.release->points.insert(strokes.release->points.begin(), {mm, 0.6 * force - off});
  }
  return strokes;
}

}  // namespace

TEST_CASE("Copies have equal axes", "[copies]") {
  CHECK(haveSameAxes(axes(), axes(4.02, 119.5)));
  CHECK_FALSE(haveSameAxes(axes(), axes(4.5)));
  CHECK_FALSE(haveSameAxes(axes(), axes(4, 120, "cN")));
}

TEST_CASE("Two traces of one drawing are copies, however dense and noisy", "[copies]") {
  const auto apart = distanceBetween(pair(900), pair(60, 0.003));
  REQUIRE(apart);
  CHECK(*apart < copiesWithin);
  CHECK(distanceBetween(pair(300), pair(300)).value() == Approx(0).margin(1e-9));
}

TEST_CASE("Another switch on equal axes is no copy", "[copies]") {
  CHECK(distanceBetween(pair(300), pair(300, 0, 0.02)).value() > copiesWithin);
  StrokePair pressOnly = pair(300);
  pressOnly.release.reset();
  CHECK_FALSE(distanceBetween(pair(300), pressOnly));
  CHECK_FALSE(distanceBetween({}, pair(300)));
}

TEST_CASE("The surer copy, then the exact one, then the larger one", "[copies]") {
  CHECK(isBetterCopy({0.9, false, 1e4}, {0.7, true, 1e6}));
  CHECK(isBetterCopy({0.85, true, 1e4}, {0.9, false, 1e6}));
  CHECK(isBetterCopy({0.9, false, 1e6}, {0.9, false, 1e4}));
  CHECK_FALSE(isBetterCopy({0.9, false, 1e4}, {0.9, false, 1e4}));
}
