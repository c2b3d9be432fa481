// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/curve_colour.h"

#include <algorithm>
#include <cmath>

#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

constexpr int kReach_px = 14;            // on either side of a line's middle
constexpr float kCurveCoverage = 0.12F;  // coverage; less ends a line

}  // namespace

PaletteColour paletteColourOf(Rgb color, Color3 paper) {
  const Color3 difference = color3Of(color) - paper;
  PaletteColour colour;
  colour.strength = std::max(1.0F, norm(difference));
  colour.direction = (1 / colour.strength) * difference;
  return colour;
}

CoverageAcross ColourOnArea::across(double x, double y, bool plumb) const {
  const auto value = [&](int along) {
    return plumb ? at(along, static_cast<int>(std::lround(y))) : at(static_cast<int>(std::lround(x)), along);
  };
  const int from = static_cast<int>(std::lround(plumb ? x : y));
  int middle = from;
  for (const int near : {from, from - 1, from + 1, from - 2, from + 2})
    if (value(near) > value(middle)) middle = near;
  CoverageAcross run;
  if (value(middle) < kCurveCoverage) return run;
  double moment = 0;
  const auto take = [&](int along) {
    const double v = static_cast<double>(value(along));
    run.thickness_px += v;
    moment += v * along;
  };
  take(middle);
  for (const int step : {-1, 1})
    for (int k = 1; k <= kReach_px && value(middle + step * k) >= kCurveCoverage; ++k)
      take(middle + step * k);
  run.middle = moment / run.thickness_px;
  return run;
}

double ColourOnArea::thicknessAlong(const std::vector<Point>& points) const {
  constexpr std::size_t samples = 120, reach = 3, fewest = 6;
  std::vector<double> runs;
  const std::size_t step = std::max<std::size_t>(1, points.size() / samples);
  for (std::size_t i = 0; i + 1 < points.size(); i += step) {
    const std::size_t to = std::min(points.size() - 1, i + reach);
    const Point along = points[to] - points[i];
    const double length = norm(along);
    if (length <= 0) continue;
    const bool plumb = std::abs(along.y) > std::abs(along.x);
    const Point middle = 0.5 * (points[i] + points[to]);
    const double run = across(middle.x, middle.y, plumb).thickness_px;
    if (run > 0) runs.push_back(run * std::max(std::abs(along.x), std::abs(along.y)) / length);
  }
  // Letters, the other stroke and crossing lines make runs longer, never shorter.
  return runs.size() < fewest ? 0 : quantileOf(runs, 0.35);
}

bool PlumbLane::onLevelLine(double y) const { return isAtOneOf(area_.rows_px, y, 3); }

std::vector<double> PlumbLane::rows(double y0, double y1) const {
  std::vector<double> thicknesses;
  for (int y = static_cast<int>(std::ceil(y0)); y <= y1; ++y)
    if (!onLevelLine(y)) thicknesses.push_back(colour_.across(x_, y, true).thickness_px);
  return thicknesses;
}

double PlumbLane::top(double baseline, double least_px, double gap_px) const {
  double last = baseline, missed = 0;
  for (double y = baseline; y >= area_.frame.y0 - 0.5 && missed <= gap_px; y -= 1) {
    if (onLevelLine(y)) continue;
    if (colour_.across(x_, y, true).thickness_px >= least_px)
      last = y, missed = 0;
    else
      missed += 1;
  }
  return last;
}

double PlumbLane::middle(double y0, double y1) const {
  std::vector<double> middles;
  for (int y = static_cast<int>(std::ceil(y0)); y <= y1; ++y)
    if (const auto run = colour_.across(x_, y, true); !onLevelLine(y) && run.thickness_px > 0)
      middles.push_back(run.middle);
  return middles.empty() ? x_ : quantileOf(middles, 0.5);
}

}  // namespace detent::importer::trace
