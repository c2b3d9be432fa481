// SPDX-License-Identifier: GPL-3.0-or-later
// Lines in colour at half resolution get their colour back; pictures at full resolution stay as they are.

#include "importer/trace/settled_chroma.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch.hpp>

using namespace detent::importer;
using namespace detent::importer::trace;

namespace {

constexpr int width = 120, height = 90;
constexpr Rgb white{255, 255, 255}, red{190, 20, 60}, green{30, 120, 40};

/// Two slanted lines, antialiased, on paper.
Raster twoLines(double thickness_px) {
  Raster raster{width, height, std::vector<std::uint8_t>(3 * width * height, 255)};
  const auto draw = [&](double from, double slope, Rgb colour) {
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double off = std::abs(y - from - slope * x) / std::hypot(1, slope);
        const double cover = std::clamp(thickness_px / 2 + 0.5 - off, 0.0, 1.0);
        std::uint8_t* p = raster.rgb.data() + 3 * (y * width + x);
        const std::array<std::uint8_t, 3> full{colour.r, colour.g, colour.b};
        for (std::size_t c = 0; c < 3; ++c)
          p[c] = static_cast<std::uint8_t>(std::lround(p[c] + cover * (full[c] - p[c])));
      }
  };
  draw(20, 0.2, red);
  draw(70, -0.25, green);
  return raster;
}

std::array<double, 3> toYcc(const std::uint8_t* p) {
  const double y = 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
  return {y, 0.564 * (p[2] - y), 0.713 * (p[0] - y)};
}

/// As 4:2:0 stores it: one colour for each block of 2 x 2 pixels, shown smoothly.
Raster withHalfColour(const Raster& sharp) {
  Raster out = sharp;
  const auto block = [&](int bx, int by, std::size_t c) {
    bx = std::clamp(bx, 0, width / 2 - 1), by = std::clamp(by, 0, height / 2 - 1);
    double sum = 0;
    for (int k = 0; k < 4; ++k) sum += toYcc(sharp.at(2 * bx + k % 2, 2 * by + k / 2))[c] / 4;
    return sum;
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::array<double, 3> ycc = toYcc(sharp.at(x, y));
      const int bx = x / 2, by = y / 2, sx = x % 2 ? 1 : -1, sy = y % 2 ? 1 : -1;
      for (std::size_t c : {1U, 2U})
        ycc[c] = (9 * block(bx, by, c) + 3 * block(bx + sx, by, c) + 3 * block(bx, by + sy, c) +
                  block(bx + sx, by + sy, c)) /
                 16;
      const double r = ycc[0] + ycc[2] / 0.713, b = ycc[0] + ycc[1] / 0.564;
      const double g = (ycc[0] - 0.299 * r - 0.114 * b) / 0.587;
      std::uint8_t* p = out.rgb.data() + 3 * (y * width + x);
      const auto level = [](double v) { return static_cast<std::uint8_t>(std::clamp(v + 0.5, 0.0, 255.0)); };
      p[0] = level(r), p[1] = level(g), p[2] = level(b);
    }
  return out;
}

/// Pixels with clearly more colour than the sharp picture has there.
int strayColour(const Raster& raster, const Raster& sharp) {
  int stray = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto here = toYcc(raster.at(x, y)), due = toYcc(sharp.at(x, y));
      stray += std::hypot(here[1], here[2]) > std::hypot(due[1], due[2]) + 10;
    }
  return stray;
}

}  // namespace

TEST_CASE("colour at half resolution moves back to its lines", "[settled_chroma]") {
  for (double thickness_px : {3.0}) {
    INFO("thickness " << thickness_px);
    const Raster sharp = twoLines(thickness_px);
    Raster raster = withHalfColour(sharp);
    const int before = strayColour(raster, sharp);
    REQUIRE(before > 50);
    settleChroma(raster, white);
    CHECK(strayColour(raster, sharp) < before / 3);
  }
}

TEST_CASE("a picture whose colour is at full resolution is left alone", "[settled_chroma]") {
  const Raster sharp = twoLines(2);
  Raster raster = sharp;
  settleChroma(raster, white);
  CHECK(raster.rgb == sharp.rgb);
}

TEST_CASE("no picture, no colour: nothing happens", "[settled_chroma]") {
  Raster empty;
  settleChroma(empty, white);
  CHECK(empty.rgb.empty());
  Raster grey{2, 2, std::vector<std::uint8_t>(12, 90)};
  settleChroma(grey, white);
  CHECK(grey.rgb == std::vector<std::uint8_t>(12, 90));
}
