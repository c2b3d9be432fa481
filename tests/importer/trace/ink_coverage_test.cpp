// SPDX-License-Identifier: GPL-3.0-or-later
// Unmixing pixels whose inks are known to the last level.

#include "importer/trace/ink_coverage.h"

#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

using namespace detent;
using namespace detent::importer;
using namespace detent::importer::trace;

namespace {

constexpr int kWidth_px = 60, kHeight_px = 40, kLine_px = 20;
constexpr Rgb kWhite{255, 255, 255}, kGrey{180, 180, 180}, kRed{220, 30, 40};

/// White paper with grey lines across and a short red stroke over one of them.
PlotArea areaWithLine() {
  PlotArea area;
  area.raster.width_px = kWidth_px;
  area.raster.height_px = kHeight_px;
  for (int y = 0; y < kHeight_px; ++y)
    for (int x = 0; x < kWidth_px; ++x) {
      const Rgb color = x == 30 && std::abs(y - kLine_px) < 8 ? kRed : y % 10 == 0 ? kGrey : kWhite;
      area.raster.rgb.insert(area.raster.rgb.end(), {color.r, color.g, color.b});
    }
  area.frame = {0, 0, kWidth_px - 1, kHeight_px - 1};
  area.rows_px = {0, 10, kLine_px, 30};
  return area;
}

}  // namespace

TEST_CASE("unmix: an ink that is what lies behind it explains nothing there") {
  const PlotArea area = areaWithLine();
  const Backdrop backdrop = Backdrop::measure(area);
  REQUIRE(backdrop.onLine(5, kLine_px));
  const Coverage coverage = unmix(area, backdrop, {inkOfColor(kGrey, backdrop), inkOfColor(kRed, backdrop)});
  for (int y : {kLine_px - 5, kLine_px}) {
    INFO("row " << y);
    CHECK(coverage.ink[0].at(30, y) == 0);
    CHECK(coverage.ink[1].at(30, y) == Approx(1).margin(0.01));
  }
  for (const Plane& ink : coverage.ink)
    for (float value : ink.values) REQUIRE(std::isfinite(value));
}
