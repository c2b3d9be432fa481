// SPDX-License-Identifier: GPL-3.0-or-later
// Lines that pass straight through each other, separated from lines that touch and part again.

#include "importer/trace/loop_crossing.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

using namespace detent::importer;
using namespace detent::importer::trace;

namespace {

constexpr double width_px = 2, size_px = 1000;

/// y by x, 600 px from left to right; forces grow upwards.
template <class Row>
std::vector<Point> line(Row row) {
  std::vector<Point> points;
  for (int x = 0; x <= 600; ++x) points.push_back({double(x), row(double(x))});
  return points;
}

/// The upper and the lower outline of two lines.
template <class First, class Second>
bool cross(First first, Second second) {
  return linesCross(line([&](double x) { return std::min(first(x), second(x)); }),
                    line([&](double x) { return std::max(first(x), second(x)); }), width_px, size_px);
}

}  // namespace

TEST_CASE("Lines that cross do, at small angles and large ones, straight and bent", "[crossing]") {
  const auto level = [](double) { return 300.0; };
  for (const double slope : {0.25, 0.6, 1.0, 2.0}) {
    CAPTURE(slope);
    CHECK(cross(level, [&](double x) { return 300 - slope * (x - 280); }));
    CHECK(cross([&](double x) { return 300 + 0.5 * slope * (x - 280); },
                [&](double x) { return 300 - 0.5 * slope * (x - 280); }));
  }
  CHECK(cross([](double x) { return 300 + 60 * std::sin(x / 90); }, [](double x) { return 340 - 0.3 * x; }));
}

TEST_CASE("Strokes that run close to each other up one steep rise do not cross", "[crossing]") {
  // Both curves bend up and level out again, the lower one a few px lower. At their common band the upper
  // one enters level and leaves steep, the lower one enters steep and leaves level.
  const double lower_px = GENERATE(14.0, 20.0), width = GENERATE(3.0, 5.0);
  const auto bent = [](double along, double shifted_px) {
    const double flat_px = 300, rise_px = 60, run_px = 12;
    const double up = std::clamp((along - flat_px) / std::hypot(rise_px, run_px), 0.0, 1.0);
    const double x =
        std::min(along, flat_px) + run_px * up + std::max(0.0, along - flat_px - std::hypot(rise_px, run_px));
    return Point{x, 300 + shifted_px - rise_px * up - 0.05 * x};
  };
  std::vector<Point> upper, lower;
  for (double along = 0; along <= 400; along += 1) {
    upper.push_back(bent(along, 0));
    lower.push_back(bent(along, lower_px));
  }
  CHECK_FALSE(linesCross(upper, lower, width, size_px));
}

TEST_CASE("Lines that touch, merge or end in one point do not cross", "[crossing]") {
  const auto level = [](double) { return 300.0; };
  CHECK_FALSE(
      cross(level, [](double x) { return 300 + 0.002 * (x - 300) * (x - 300); }));    // touches from below
  CHECK_FALSE(cross(level, [](double x) { return 300 + 0.5 * std::abs(x - 300); }));  // a tip on a line
  CHECK_FALSE(cross(level, [](double x) { return 300 + 0.5 * std::max(0.0, 200 - x); }));  // merges for good
  CHECK_FALSE(cross(level, [](double x) { return 300 + 0.5 * x; }));  // begins in one point
  CHECK_FALSE(cross(level, [](double) { return 340.0; }));
  CHECK_FALSE(linesCross({}, {}, width_px, size_px));
}
