// SPDX-License-Identifier: GPL-3.0-or-later
// A curve that is drawn beyond its frame's right edge takes the frame with it.

#include "importer/wider_frame.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::importer;

namespace {

/// A frame from (100, 100) to (500, 500) of a white picture of 700 x 600; 100 px are a millimetre. A rising
/// line in red is drawn as far as wanted and followed to the frame.
struct Plot {
  LocatedGraph graph;
  std::vector<CurveTrace> curves{1};

  explicit Plot(int drawnTo_px) {
    Raster& picture = graph.view.raster;
    picture.width_px = 700, picture.height_px = 600;
    picture.rgb.assign(3UL * 700 * 600, 255);
    graph.frame.value.corners = {Point{100, 100}, Point{500, 100}, Point{500, 500}, Point{100, 500}};
    AxisCalibration& axes = graph.axes.calibration.value;
    axes.viewToUnits = {0.01, 0, -1, 0, -0.01, 5, 0, 0, 1};
    axes.x.min = 0, axes.x.max = 4;
    curves.front().color = {200, 30, 30};
    for (int x = 100; x <= drawnTo_px; ++x) {
      std::uint8_t* p = picture.rgb.data() + 3 * (700 * std::lround(row(x)) + x);
      p[0] = 200, p[1] = p[2] = 30;
      if (x <= 500) curves.front().points_px.push_back({double(x), row(x)});
    }
  }
  static double row(int x) { return 450 - 0.5 * (x - 100); }
  bool isWidened() const { return widenedToItsCurves(graph, curves).has_value(); }
};

}  // namespace

TEST_CASE("a frame is widened to where its curve's pixels end, and the scale goes on") {
  const Plot plot(530);
  const auto wider = widenedToItsCurves(plot.graph, plot.curves);
  REQUIRE(wider);
  const Box box = wider->frame.value.box();
  CHECK(box.x1 > 530);
  CHECK(box.x1 < 540);
  CHECK(box.x0 == 100);
  CHECK(box.y0 == 100);
  const AxisCalibration& axes = wider->axes.calibration.value;
  CHECK(axes.x.max == Approx(axes.toUnits(wider->frame.value.corners[1]).x));
}

TEST_CASE("a frame is widened by as much as a step of its numbers, to the right and upwards") {
  Plot plot(620);
  AxisCalibration& axes = plot.graph.axes.calibration.value;
  axes.y.min = 0, axes.y.max = 4;
  for (double at = 100; at <= 500; at += 200) {
    axes.x.ticks.emplace_back().position_px = at;
    if (at > 100) axes.y.ticks.emplace_back().position_px = at;  // none above where the curve ends
  }
  CHECK(plot.isWidened());
  plot.graph.frame.value.corners[0].y = plot.graph.frame.value.corners[1].y = 250;  // the end of the curve
  plot.graph.frame.value.corners[1].x = plot.graph.frame.value.corners[2].x = 560;
  const auto wider = widenedToItsCurves(plot.graph, plot.curves);
  REQUIRE(wider);
  const Box box = wider->frame.value.box();
  CHECK(box.x1 == Approx(626).margin(4));
  CHECK(box.y0 == Approx(186).margin(4));
  axes.y.ticks.clear();  // nothing says how far a step is
  CHECK_FALSE(plot.isWidened());
}

TEST_CASE(
    "a frame that a curve leaves upwards goes to the last number above it, through writing that hides the "
    "curve") {
  Plot plot(300);
  AxisCalibration& axes = plot.graph.axes.calibration.value;
  axes.y.min = 0, axes.y.max = 2;
  for (double at = 300; at <= 500; at += 20) axes.y.ticks.emplace_back().position_px = at;
  plot.graph.frame.value.corners[0].y = plot.graph.frame.value.corners[1].y = 400;
  std::erase_if(plot.curves.front().points_px, [](Point p) { return p.y < 400; });
  for (int y = 370; y < 385; ++y) {  // letters
    std::uint8_t* row = plot.graph.view.raster.rgb.data() + 3 * 700 * y;
    std::fill(row + 3 * 200, row + 3 * 290, std::uint8_t{0});
  }
  const auto wider = widenedToItsCurves(plot.graph, plot.curves);
  REQUIRE(wider);
  CHECK(wider->frame.value.box().y0 == Approx(297).margin(2));
}

TEST_CASE("a frame stays where no curve leaves it") {
  CHECK_FALSE(Plot(450).isWidened());
  CHECK_FALSE(Plot(502).isWidened());  // a line's own end
}

TEST_CASE("a frame stays where the pixels do not end near it") {
  CHECK_FALSE(Plot(620).isWidened());  // more than a fifth of its width
  Plot atEdge(530);
  atEdge.graph.view.raster.width_px = 530;  // the picture is cut through the curve
  atEdge.graph.view.raster.rgb.resize(3UL * 530 * 600);
  CHECK_FALSE(atEdge.isWidened());
}

TEST_CASE("a frame stays where its scale is contradicted or it leans") {
  Plot contradicted(530);
  contradicted.graph.axes.remarks.push_back({RemarkCode::labelContradicts, {"60", "y", "40"}});
  CHECK_FALSE(contradicted.isWidened());
  Plot leaning(530);
  leaning.graph.frame.value.corners[1].y += 4;
  CHECK_FALSE(leaning.isWidened());
}

TEST_CASE("a bottom-out that begins just beyond the frame extends it") {
  Plot plot(504);
  Raster& picture = plot.graph.view.raster;
  const int lowEdge = static_cast<int>(std::lround(Plot::row(504)));
  for (int y = lowEdge; y > lowEdge - 100; --y)
    for (int x = 504; x < 506; ++x) {
      std::uint8_t* p = picture.rgb.data() + 3 * (700 * y + x);
      p[0] = 200, p[1] = p[2] = 30;
    }
  CHECK(plot.isWidened());
  Plot ends(504);  // and then nothing
  CHECK_FALSE(ends.isWidened());
}
