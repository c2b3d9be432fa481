// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/plot_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

void addDots(std::vector<PixelAt>& dots, const ColourOnArea& coverage, const PlotArea& area, double at,
             bool plumb) {
  constexpr double inked_px = 0.3, least = 0.15, most = 0.8;  // px; covered shares of a stretch
  constexpr std::size_t stretches = 10, mostOther = 2, window = 12;
  const std::vector<double> runs = runsAlong(coverage, area, at, plumb);
  std::vector<double> before{0}, thick;  // covered pixels before each place
  for (const double run : runs) {
    before.push_back(before.back() + (run > inked_px ? 1 : 0));
    if (run > inked_px) thick.push_back(run);
  }
  const auto shareOf = [&](std::size_t from, std::size_t to) {
    return (before[to] - before[from]) / static_cast<double>(std::max<std::size_t>(1, to - from));
  };
  std::size_t other = 0;
  for (std::size_t k = 0; k < stretches; ++k) {
    const double share = shareOf(k * runs.size() / stretches, (k + 1) * runs.size() / stretches);
    other += share < least || share > most ? 1 : 0;
  }
  if (other > mostOther) return;
  const double most_px = kLineTimes * quantileOf(thick, 0.5) + 0.4;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i] <= most_px && shareOf(i - std::min(i, window), std::min(i + window + 1, runs.size())) <= most)
      forPixelsAcross(area, static_cast<int>(i), at, most_px, plumb, [&](int x, int y) {
        dots.push_back({x, y});
      });
}

}  // namespace

std::vector<double> runsAlong(const ColourOnArea& coverage, const PlotArea& area, double at, bool plumb) {
  std::vector<double> runs;
  const int length = plumb ? area.raster.height_px : area.raster.width_px;
  for (int i = 0; i < length; ++i)
    runs.push_back(plumb ? coverage.across(at, i, true).thickness_px
                         : coverage.across(i, at, false).thickness_px);
  return runs;
}

void forPixelsAcross(const PlotArea& area, int along, double at, double most_px, bool plumb,
                     const std::function<void(int, int)>& visit) {
  const int lanes = plumb ? area.raster.width_px : area.raster.height_px,
            reach = static_cast<int>(std::ceil(0.5 * most_px)) + 2;
  for (int lane = static_cast<int>(std::lround(at)) - reach; lane <= std::lround(at) + reach; ++lane)
    if (lane >= 0 && lane < lanes) plumb ? visit(lane, along) : visit(along, lane);
}

std::vector<PixelAt> dottedLines(const ColourOnArea& coverage, const PlotScene& scene) {
  const PlotArea& area = scene.area();
  const Box box = scene.plotFrame().box();
  std::vector<PixelAt> dots;
  for (const GridLine& line : scene.plotFrame().xLines)
    addDots(dots, coverage, area, area.fromView({line.position_px, box.y1}).x, true);
  for (const GridLine& line : scene.plotFrame().yLines)
    addDots(dots, coverage, area, area.fromView({box.x0, line.position_px}).y, false);
  return dots;
}

}  // namespace detent::importer::trace
