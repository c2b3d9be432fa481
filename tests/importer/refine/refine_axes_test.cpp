// SPDX-License-Identifier: GPL-3.0-or-later
// Grids drawn pixel by pixel on sheets whose tilt and bend are known.
#include "importer/refine/refine_axes.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <opencv2/imgproc.hpp>

using namespace detent;
using namespace detent::importer;

namespace {

constexpr double travel_mm = 4, force_N = 1.5;
constexpr int width_px = 1000, height_px = 760;

double offGrid(double value, double step) { return std::abs(value - step * std::round(value / step)); }

/// The sheet that the pictures are drawn from: 800 x 600 px, tilted a little on request.
AxisCalibration sheet(double tilt, std::optional<SheetBend> bend) {
  AxisCalibration truth;
  truth.x.max = travel_mm, truth.x.unit = "mm";
  truth.y.max = force_N, truth.y.unit = "N";
  // 100..900 px are 0..4 mm, 680..80 px are 0..1.5 N.
  truth.viewToUnits = Homography{
      {travel_mm / 800, 0, -100 * travel_mm / 800, 0, -force_N / 600, 680 * force_N / 600, 0, 0,
       1}}.after(Homography{{1, 0, 0, 0, 1, 0, tilt, -tilt / 2, 1}});
  truth.bend = bend;
  return truth;
}

/// Gridlines of every mm and half newton, about 1.5 px wide, or the frame's edges alone.
Raster drawn(const AxisCalibration& truth, bool grid) {
  Raster raster;
  raster.width_px = width_px, raster.height_px = height_px;
  raster.rgb.assign(std::size_t{3} * width_px * height_px, 255);
  const double stepX = grid ? 1 : travel_mm, stepY = grid ? 0.5 : force_N;
  const Point margin{0.002 * travel_mm, 0.002 * force_N};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const Point p{double(x), double(y)}, at = truth.toUnits(p);
      if (at.x < -margin.x || at.x > travel_mm + margin.x || at.y < -margin.y || at.y > force_N + margin.y)
        continue;
      const double perX = std::abs(truth.toUnits({p.x + 1, p.y}).x - at.x),
                   perY = std::abs(truth.toUnits({p.x, p.y + 1}).y - at.y);
      const double away_px = std::min(offGrid(at.x, stepX) / perX, offGrid(at.y, stepY) / perY);
      const double darkness = std::clamp(1.25 - away_px, 0.0, 1.0);
      const auto grey = static_cast<unsigned char>(std::lround(255 - 200 * darkness));
      for (int c = 0; c < 3; ++c) raster.rgb[static_cast<std::size_t>(3 * (y * width_px + x) + c)] = grey;
    }
  return raster;
}

struct Scene {
  PageView view;
  PlotFrame frame;
  AxisCalibration asRead;  ///< through the four corners alone
};

Scene sceneOf(const AxisCalibration& truth, bool grid = true) {
  Scene scene;
  scene.view.raster = drawn(truth, grid);
  scene.frame.corners = {truth.toView({0, force_N}), truth.toView({travel_mm, force_N}),
                         truth.toView({travel_mm, 0}), truth.toView({0, 0})};
  scene.asRead = truth;
  scene.asRead.bend.reset();
  for (double v = 0; v <= travel_mm; v += 1) {
    const double at_px = truth.toView({v, 0}).x;
    scene.frame.xLines.push_back({at_px, 1.5, grid});
    scene.asRead.x.ticks.push_back({at_px, v, "", {}, true});
  }
  for (double v = 0; v <= force_N; v += 0.5) {
    const double at_px = truth.toView({0, v}).y;
    scene.frame.yLines.push_back({at_px, 1.5, grid});
    scene.asRead.y.ticks.push_back({at_px, v, "", {}, true});
  }
  std::vector<cv::Point2f> from;
  for (const Point& c : scene.frame.corners) from.emplace_back(float(c.x), float(c.y));
  const std::vector<cv::Point2f> to{
      {0, float(force_N)}, {float(travel_mm), float(force_N)}, {float(travel_mm), 0}, {0, 0}};
  const cv::Matx33d map = cv::getPerspectiveTransform(from, to);
  std::copy(map.val, map.val + 9, scene.asRead.viewToUnits.m.begin());
  return scene;
}

/// Farthest that a calibration is off inside the frame, view pixels.
double worst_px(const AxisCalibration& calibration, const AxisCalibration& truth) {
  double worst = 0;
  for (double x = 0.05; x < 1; x += 0.1)
    for (double y = 0.05; y < 1; y += 0.1) {
      const Point units{x * travel_mm, y * force_N};
      worst = std::max(worst, distance(calibration.toView(units), truth.toView(units)));
    }
  return worst;
}

SheetBend sag() { return {{500, 380}, 400, {0.004, -0.003, 0.002}, {-0.9, 0.6}}; }

}  // namespace

TEST_CASE("a bend moves points and back again") {
  const SheetBend bend = sag();
  const Point p{140, 620}, straight = bend.straightened(p);
  CHECK(distance(p, straight) > 1);
  CHECK(distance(bend.bent(straight), p) < 1e-9);
  const AxisCalibration truth = sheet(2e-5, bend);
  const Point units = truth.toUnits(p);
  CHECK(distance(truth.toView(units), p) < 1e-6);
}

TEST_CASE("what sags and tilts is found from its gridlines") {
  const AxisCalibration truth = sheet(2e-5, sag());
  const Scene scene = sceneOf(truth);
  REQUIRE(worst_px(scene.asRead, truth) > 1);
  const auto refined = refineAxes(scene.view, scene.frame, scene.asRead);
  REQUIRE(refined);
  CHECK(refined->shape == SheetShape::bent);
  CHECK(worst_px(refined->calibration, truth) < 0.15);
  CHECK(refined->after_px < 0.2 * refined->before_px);
}

TEST_CASE("a flat upright picture keeps the axes that were read") {
  const AxisCalibration truth = sheet(0, {});
  const Scene scene = sceneOf(truth);
  const auto refined = refineAxes(scene.view, scene.frame, scene.asRead);
  REQUIRE(refined);
  CHECK(refined->shape == SheetShape::asRead);
  CHECK(refined->calibration.viewToUnits == scene.asRead.viewToUnits);
  CHECK_FALSE(refined->calibration.bend);
}

TEST_CASE("a corner read beside its place is corrected by the lines") {
  const AxisCalibration truth = sheet(2e-5, {});
  Scene scene = sceneOf(truth);
  scene.asRead.viewToUnits = scene.asRead.viewToUnits.after(Homography{{1, 0.003, 0, 0, 1, 0, 0, 0, 1}});
  REQUIRE(worst_px(scene.asRead, truth) > 1);
  const auto refined = refineAxes(scene.view, scene.frame, scene.asRead);
  REQUIRE(refined);
  CHECK(refined->shape == SheetShape::tilted);
  CHECK(worst_px(refined->calibration, truth) < 0.15);
}

TEST_CASE("edges alone tell how a sheet sags, and no twist") {
  SheetBend cylinder = sag();
  cylinder.depth = {0.004, 0, 0};
  const AxisCalibration truth = sheet(2e-5, cylinder);
  const Scene scene = sceneOf(truth, false);
  const auto refined = refineAxes(scene.view, scene.frame, scene.asRead);
  REQUIRE(refined);
  CHECK(worst_px(refined->calibration, truth) < 0.5 * worst_px(scene.asRead, truth));
  if (refined->calibration.bend) CHECK(refined->calibration.bend->depth[1] == 0);
}

TEST_CASE("without lines that tell, nothing is refined") {
  const AxisCalibration truth = sheet(0, {});
  Scene scene = sceneOf(truth);
  SECTION("an empty picture") {
    std::fill(scene.view.raster.rgb.begin(), scene.view.raster.rgb.end(), static_cast<unsigned char>(255));
  }
  SECTION("no picture") { scene.view.raster = {}; }
  CHECK_FALSE(refineAxes(scene.view, scene.frame, scene.asRead));
}

TEST_CASE("the stated error is of the size of the real one") {
  const AxisCalibration truth = sheet(2e-5, sag());
  Scene scene = sceneOf(truth);
  cv::RNG noise(20261124);
  for (auto& sample : scene.view.raster.rgb)
    sample = static_cast<unsigned char>(std::clamp(std::lround(sample + noise.gaussian(12)), 0L, 255L));
  const auto refined = refineAxes(scene.view, scene.frame, scene.asRead);
  REQUIRE(refined);
  const Point at{0.4 * travel_mm, 0.6 * force_N};
  const Point off = refined->calibration.toUnits(truth.toView(at)) - at;
  const PointNoise sigma = refined->sigmaAt(at);
  CHECK(sigma.sigma_mm > 0);
  CHECK(sigma.sigma_mm < 0.3 * truth.mmPerPx());
  CHECK(std::abs(off.x) < 4 * sigma.sigma_mm);
  CHECK(std::abs(off.y) < 4 * sigma.sigma_N);
}
