// SPDX-License-Identifier: GPL-3.0-or-later
// Unmixing pixels whose colours are known to the last level.

#include "importer/trace/colour_coverage.h"

#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>
#include <opencv2/imgproc.hpp>

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::trace;

namespace {

constexpr int kWidth_px = 60, kHeight_px = 40, kLine_px = 20;
constexpr Rgb kCoverageWhite{255, 255, 255}, kCoverageGrey{180, 180, 180}, kCoverageRed{220, 30, 40};

/// White paper with grey lines across and a short red stroke over one of them.
PlotScene sceneWithLine() {
  Raster raster{kWidth_px, kHeight_px, {}};
  for (int y = 0; y < kHeight_px; ++y)
    for (int x = 0; x < kWidth_px; ++x) {
      const Rgb color = x == 30 && std::abs(y - kLine_px) < 8 ? kCoverageRed
                        : y % 10 == 0                         ? kCoverageGrey
                                                              : kCoverageWhite;
      raster.rgb.insert(raster.rgb.end(), {color.r, color.g, color.b});
    }
  constexpr double right = kWidth_px - 1, bottom = kHeight_px - 1;
  PlotFrame frame;
  frame.corners = {{{0, 0}, {right, 0}, {right, bottom}, {0, bottom}}};
  for (double y : {10, kLine_px, 30}) frame.yLines.push_back({y, true});
  return {raster, frame};
}

}  // namespace

TEST_CASE("unmix: a colour equal to its background explains nothing there") {
  const PlotScene scene = sceneWithLine();
  REQUIRE(scene.onLine(5, kLine_px));
  const Coverage coverage = unmix(
      scene, {paletteColourOf(kCoverageGrey, scene.paper()), paletteColourOf(kCoverageRed, scene.paper())});
  for (int y : {kLine_px - 5, kLine_px}) {
    INFO("row " << y);
    CHECK(coverage.planes[0].at(30, y) == 0);
    CHECK(coverage.planes[1].at(30, y) == Approx(1).margin(0.01));
  }
  for (const Plane& plane : coverage.planes)
    for (float value : plane.values) REQUIRE(std::isfinite(value));
}

TEST_CASE("scene: a colour's coverage is what is like it, lines too, and is reckoned once") {
  const PlotScene scene = sceneWithLine();
  const ColourOnArea& red = scene.coverageOf(kCoverageRed);
  CHECK(red.distinct());
  CHECK(red.at(30, kLine_px) == Approx(1).margin(0.01));
  CHECK(red.at(5, kLine_px) == 0);
  CHECK(scene.coverageOf(kCoverageGrey).at(5, kLine_px) == Approx(1).margin(0.01));
  CHECK(red.at(-1, kLine_px) == 0);
  CHECK(&scene.coverageOf(kCoverageRed) == &red);
  CHECK(&scene.lettering() == &scene.lettering());
  CHECK(scene.lettering().mask.size() == scene.area().pixels());
}

TEST_CASE("palette: black letters are a colour beside grey lines") {
  constexpr int width_px = 300, height_px = 160;
  Raster raster{width_px, height_px, std::vector<std::uint8_t>(3 * width_px * height_px, 255)};
  cv::Mat picture(height_px, width_px, CV_8UC3, raster.rgb.data());
  for (int x : {60, 120, 180})
    cv::line(picture, {x, 0}, {x + 20, height_px}, cv::Scalar::all(170), 2, cv::LINE_AA);
  cv::putText(picture, "press", {12, 30}, cv::FONT_HERSHEY_SIMPLEX, 0.6, cv::Scalar::all(0), 1, cv::LINE_8);
  PlotFrame frame;
  frame.corners = {{{0, 0}, {width_px - 1, 0}, {width_px - 1, height_px - 1}, {0, height_px - 1}}};
  const PlotScene scene(raster, frame, {{"press", {10, 12, 70, 36}, 1.0, 0}});
  std::vector<PaletteColour> colours = findColours(scene, scene.lettering().mask);
  REQUIRE(colours.size() == 1);
  addLetterColour(colours, scene);
  REQUIRE(colours.size() == 2);
  CHECK(colours[1].strength > 400);
  addLetterColour(colours, scene);
  CHECK(colours.size() == 2);
}

TEST_CASE("scene: none where the frame lies outside the view") {
  PlotFrame frame;
  frame.corners = {{{90, 0}, {99, 0}, {99, 20}, {90, 20}}};
  CHECK(PlotScene(Raster{kWidth_px, kHeight_px, std::vector<std::uint8_t>(3 * kWidth_px * kHeight_px, 255)},
                  frame)
            .empty());
}
