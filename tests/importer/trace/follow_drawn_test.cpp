// SPDX-License-Identifier: GPL-3.0-or-later
// Lines drawn by hand beside their curve: their distance from it, and that nothing else pulls them away.
#include "importer/trace/follow_drawn.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

struct Colour {
  double r, g, b;
};
constexpr Colour black{20, 20, 20}, grey{190, 190, 190}, red{210, 40, 40};

/// White paper on which lines are laid by coverage.
class Paper {
 public:
  Paper(int width, int height) {
    raster.width_px = width, raster.height_px = height;
    raster.rgb.assign(static_cast<std::size_t>(width * height * 3), 255);
  }
  template <class Y>
  void curve(const Y& y, Colour colour, double width_px, double from = 0, double to = 1e9) {
    for (int x = 0; x < raster.width_px; ++x) {
      const double at = x;
      if (at < from || at > to) continue;
      const double slope = (y(at + 0.5) - y(at - 0.5)), across = std::sqrt(1 + slope * slope);
      for (int row = 0; row < raster.height_px; ++row) {
        const double d = std::abs(row - y(at)) / across;
        const double cover = std::clamp(0.5 * width_px + 0.5 - d, 0.0, 1.0);
        auto* p = raster.rgb.data() + 3 * (row * raster.width_px + x);
        const double colors[3] = {colour.r, colour.g, colour.b};
        for (int c = 0; c < 3; ++c) p[c] = static_cast<std::uint8_t>(p[c] + cover * (colors[c] - p[c]));
      }
    }
  }
  Raster raster;
};

double hill(double x) { return 150 - 60 * std::exp(-(x - 150) * (x - 150) / 5000) - 0.2 * x; }

// As a hand clicks: every 25 px, off by up to `off` px.
std::vector<Point> clicked(double off) {
  std::vector<Point> points;
  for (int i = 0; i <= 14; ++i) {
    const double x = 20 + 25 * i;
    points.push_back({x, hill(x) + off * std::sin(2.1 * i)});
  }
  return points;
}

double rms(const std::vector<Point>& line, double from = 0, double to = 1e9) {
  double sum = 0;
  int n = 0;
  for (const Point& p : line) {
    if (p.x < from || p.x > to) continue;
    const double slope = hill(p.x + 0.5) - hill(p.x - 0.5);
    const double d = (p.y - hill(p.x)) / std::sqrt(1 + slope * slope);
    sum += d * d;
    ++n;
  }
  return std::sqrt(sum / n);
}

}  // namespace

TEST_CASE("a line clicked beside the curve comes to its middle") {
  for (const double width : {1.0, 2.0, 4.0}) {
    Paper paper(400, 200);
    paper.curve(hill, black, width);
    const auto drawn = clicked(3);
    const double before = rms(drawn), after = rms(followDrawn(paper.raster, drawn));
    INFO("width " << width << ": " << before << " px -> " << after << " px");
    CHECK(before > 1.5);
    CHECK(after < 0.3);
  }
}

TEST_CASE("gridlines near and across do not pull it away") {
  Paper paper(400, 200);
  for (const double y : {75.0, 115.0, 155.0}) paper.curve([y](double) { return y; }, grey, 1);
  paper.curve(hill, red, 2);
  CHECK(rms(followDrawn(paper.raster, clicked(3))) < 0.4);
}

TEST_CASE("a gap in the curve is bridged, and without a curve the line stays as drawn") {
  Paper paper(400, 200);
  paper.curve(hill, black, 2, 0, 170);
  paper.curve(hill, black, 2, 215, 400);
  const auto followed = followDrawn(paper.raster, clicked(2));
  CHECK(rms(followed, 0, 165) < 0.4);
  CHECK(rms(followed, 220, 400) < 0.4);
  CHECK(rms(followed) < 1.5);
  const Paper blank(400, 200);
  const auto drawn = clicked(0);
  for (const Point& p : followDrawn(blank.raster, drawn)) CHECK(std::abs(p.y - hill(p.x)) < 0.5);
}

TEST_CASE("a few clicks at the turns are enough, however far the curve runs from a line through them") {
  Paper paper(400, 200);
  SECTION("one curve") {}
  SECTION("a curve of another colour near and across") {
    paper.curve([](double x) { return hill(x) - 25 + 0.15 * x; }, {40, 90, 210}, 2);
  }
  SECTION("gridlines as dark as the curve") {
    for (const double y : {75.0, 115.0, 155.0}) paper.curve([y](double) { return y; }, red, 1);
  }
  paper.curve(hill, red, 2);
  const std::vector<Point> clicks{{22, hill(22)}, {150, hill(150)}, {240, hill(240)}, {380, hill(380)}};
  const auto followed = followDrawn(paper.raster, clicks);
  CHECK(rms(followed) < 0.4);
  CHECK(std::ranges::all_of(followed, [](Point p) { return std::abs(p.y - hill(p.x)) < 2; }));
  CHECK(followed.front().x < 24);
  CHECK(followed.back().x > 378);
}

TEST_CASE("a pale curve is followed though most clicks are near a stronger one that leaves it") {
  for (const double off : {0.0, 1.5, 3.0}) {
    INFO("off by " << off << " px");
    Paper paper(400, 200);
    paper.curve([](double x) { return hill(x) + 4 + 0.15 * std::max(0.0, x - 130); }, red, 2);
    paper.curve(hill, {155, 210, 205}, 2);
    std::vector<Point> clicks;
    for (const double x : {20.0, 35.0, 50.0, 70.0, 100.0, 130.0, 330.0, 380.0})
      clicks.push_back({x, hill(x) + off * std::sin(x)});
    const auto followed = followDrawn(paper.raster, clicks);
    CHECK(std::ranges::all_of(followed, [](Point p) { return std::abs(p.y - hill(p.x)) < 4; }));
    CHECK(rms(followed, 140, 380) < 0.5);
  }
}

TEST_CASE("dark paper is paper too") {
  Paper paper(400, 200);
  std::fill(paper.raster.rgb.begin(), paper.raster.rgb.end(), std::uint8_t(25));
  paper.curve(hill, {240, 240, 90}, 2);
  CHECK(rms(followDrawn(paper.raster, clicked(3))) < 0.4);
}

TEST_CASE("what is no line gives none, and what lies outside is followed as drawn") {
  const Paper paper(40, 40);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(followDrawn(paper.raster, {}).empty());
  CHECK(followDrawn(paper.raster, {{3, 3}}).empty());
  CHECK(followDrawn(paper.raster, {{3, 3}, {3, 3}}).empty());
  CHECK(followDrawn(paper.raster, {{3, 3}, {nan, 3}}).empty());
  CHECK(followDrawn({}, {{0, 0}, {10, 0}}).size() == 11);
  for (const Point& p : followDrawn(paper.raster, {{-50, -50}, {100, 90}})) CHECK(std::isfinite(p.x + p.y));
}
