// SPDX-License-Identifier: GPL-3.0-or-later
// A plot whose numbers fall is seen in a mirror: every place keeps its value and its place on the page.

#include "importer/rising_axes.h"

#include <catch2/catch.hpp>

#include "importer/page/mirrored.h"

using namespace detent;
using namespace detent::importer;

namespace {

/// 4 mm at the left of the frame to 0 at the right if travel falls; force 0 at the top to 4 N at the bottom
/// if force does.
LocatedGraph graphWith(bool travelFalls, bool forceFalls) {
  LocatedGraph graph;
  graph.view.raster.width_px = 61, graph.view.raster.height_px = 51;
  graph.view.raster.rgb.assign(3UL * 61 * 51, 255);
  graph.view.raster.rgb[3 * (61 * 7 + 20)] = 3;
  graph.view.viewToPage = {2, 0, 5, 0, 2, 9, 0, 0, 1};
  graph.frame.value.corners = {Point{10, 5}, Point{50, 5}, Point{50, 45}, Point{10, 45}};
  graph.frame.value.xLines = {{.position_px = 20}, {.position_px = 45}};
  graph.axes.texts = {{"Down", {12, 1, 30, 4}, 1, 0}};
  AxisCalibration& axes = graph.axes.calibration.value;
  axes.viewToUnits = {travelFalls ? -0.1 : 0.1,
                      0,
                      travelFalls ? 5.0 : -1.0,
                      0,
                      forceFalls ? 0.1 : -0.1,
                      forceFalls ? -0.5 : 4.5,
                      0,
                      0,
                      1};
  axes.x.min = travelFalls ? 4 : 0, axes.x.max = travelFalls ? 0 : 4;
  axes.y.min = forceFalls ? 4 : 0, axes.y.max = forceFalls ? 0 : 4;
  return graph;
}

}  // namespace

TEST_CASE("axes that rise need no mirror, and no program lets both fall") {
  CHECK_FALSE(mirroredToRise(graphWith(false, false)));
  CHECK_FALSE(mirroredToRise(graphWith(true, true)));
  LocatedGraph turned = graphWith(true, false);
  turned.candidate.value.quarterTurns = 1;
  CHECK_FALSE(mirroredToRise(turned));
}

TEST_CASE("in a mirror both scales rise, and every place keeps its value, its page and its pixel") {
  const bool across = GENERATE(true, false);
  const LocatedGraph before = graphWith(across, !across);
  const auto after = mirroredToRise(before);
  REQUIRE(after);
  const auto mirrored = [&](Point p) { return across ? Point{60 - p.x, p.y} : Point{p.x, 50 - p.y}; };
  const AxisCalibration &was = before.axes.calibration.value, &is = after->axes.calibration.value;
  for (const Point p : {Point{10, 5}, Point{33, 12}, Point{50, 45}}) {
    CHECK(distance(is.toUnits(mirrored(p)), was.toUnits(p)) < 1e-9);
    CHECK(distance(after->view.viewToPage(mirrored(p)), before.view.viewToPage(p)) < 1e-9);
  }
  CHECK(is.x.min == 0);
  CHECK(is.x.max == 4);
  CHECK(is.y.min == 0);
  CHECK(is.y.max == 4);
  const auto& corners = after->frame.value.corners;
  CHECK(corners[0].x < corners[1].x);
  CHECK(corners[0].y < corners[3].y);
  CHECK(distance(is.toUnits(corners[3]), {0, 0}) < 1e-9);  // at rest at the lower left
  const Point dot = mirrored({20, 7});
  CHECK(after->view.raster.at(static_cast<int>(dot.x), static_cast<int>(dot.y))[0] == 3);
  CHECK(after->axes.texts.front().box.middle() == mirrored(before.axes.texts.front().box.middle()));
  const auto& lines = after->frame.value.xLines;
  CHECK(lines[0].position_px < lines[1].position_px);
  CHECK(mirroredBy(after->view.viewToPage).across == across);
  CHECK(mirroredBy(after->view.viewToPage).upsideDown == !across);
}
