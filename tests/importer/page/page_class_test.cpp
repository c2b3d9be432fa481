// SPDX-License-Identifier: GPL-3.0-or-later
// A picture says by its paper how it came to be.

#include "importer/page/page_class.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

using namespace detent::importer;

namespace {

struct Style {
  double grain = 0;      ///< levels, standard deviation
  double lightFall = 0;  ///< levels from left to right
  int paper = 255;
  bool soft = true;  ///< a grey rim along the lines
};

/// A grid and a slanting curve.
Raster drawn(const Style& style) {
  constexpr int width = 640, height = 400;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  Raster raster{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double off = std::abs(y - 50 - 0.4 * x);
      double level = style.paper - style.lightFall * x / width;
      if (x % 80 == 0 || y % 80 == 0) level = style.soft ? 180 : 0;
      if (off < 3) level = style.soft ? std::max(0.0, 255 * (off - 2)) : 0;
      level += style.grain * noise(random);
      raster.rgb.insert(raster.rgb.end(), 3, static_cast<std::uint8_t>(std::clamp(level, 0.0, 255.0)));
    }
  }
  return raster;
}

}  // namespace

TEST_CASE("even paper without grain was drawn by a program, light or dark") {
  CHECK(classOfPixels(drawn({})) == PageClass::picture);
  CHECK(classOfPixels(drawn({.paper = 40})) == PageClass::picture);
  CHECK(classOfPixels(Raster{4, 4, std::vector<std::uint8_t>(48, 255)}) == PageClass::picture);
  CHECK(classOfPixels(Raster{}) == PageClass::picture);
}

TEST_CASE("a window's even greys around a plot are a program's too") {
  Raster window = drawn({.paper = 236});
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < window.width_px; ++x)
      std::fill_n(window.rgb.begin() + 3 * (std::ptrdiff_t{y} * window.width_px + x), 3,
                  static_cast<std::uint8_t>(y < 40 ? 205 : 255));
  CHECK(classOfPixels(window) == PageClass::picture);
}

TEST_CASE("grain, paper that is not quite even, black and white alone: from a scanner") {
  CHECK(classOfPixels(drawn({.grain = 2, .paper = 240})) == PageClass::scan);
  CHECK(classOfPixels(drawn({.lightFall = 10, .paper = 250})) == PageClass::scan);
  CHECK(classOfPixels(drawn({.soft = false})) == PageClass::scan);
}

TEST_CASE("light that falls off across the paper: from a camera") {
  CHECK(classOfPixels(drawn({.grain = 3, .lightFall = 60, .paper = 220})) == PageClass::photo);
}

TEST_CASE("every class has its word") {
  CHECK(nameOf(PageClass::vector) == "vector");
  CHECK(nameOf(PageClass::picture) == "picture");
  CHECK(nameOf(PageClass::scan) == "scan");
  CHECK(nameOf(PageClass::photo) == "photo");
}
