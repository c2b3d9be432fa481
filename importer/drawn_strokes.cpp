// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/drawn_strokes.h"

#include <algorithm>
#include <cmath>

#include "importer/trace/follow_drawn.h"

namespace detent::importer {
namespace {

// share of the plot frame's diagonal: accuracy of a hand on a plot that is shown as a whole
constexpr double reachShare = 0.012;
constexpr double leastReach_px = 4, mostReach_px = 24;
// A drawn line that covers less than this share of a traced stroke's displacement replaces that part alone.
constexpr double wholeStrokeShare = 0.8;

std::pair<double, double> spanOf(const StrokePoints& stroke) {
  const auto [low, high] = std::minmax_element(
      stroke.points.begin(), stroke.points.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.displacement_mm < b.displacement_mm; });
  return {low->displacement_mm, high->displacement_mm};
}

void add(StrokePoints& to, const StrokePoints& from, std::size_t i) {
  to.points.push_back(from.points[i]);
  if (i < from.points_px.size()) to.points_px.push_back(from.points_px[i]);
}

}  // namespace

StrokePoints strokeFromDrawn(const std::vector<Point>& drawn, Stroke stroke, const PageView& view,
                             const PlotFrame& frame, const AxisCalibration& calibration) {
  const Homography toView = view.viewToPage.inverse();
  std::vector<Point> drawn_px;
  for (const Point& p : drawn) drawn_px.push_back(toView(p));
  const Box box = frame.box();
  const double reach_px =
      std::clamp(reachShare * std::hypot(box.width(), box.height()), leastReach_px, mostReach_px);
  StrokePoints points;
  points.points_px = followDrawn(view.raster, drawn_px, reach_px);
  if (points.points_px.size() < 2) return {};
  const auto displacement = [&](Point p) { return calibration.toUnits(p).x; };
  const bool increases = displacement(points.points_px.front()) < displacement(points.points_px.back());
  if (increases != (stroke == Stroke::press)) std::reverse(points.points_px.begin(), points.points_px.end());
  for (const Point& p : points.points_px) {
    const Point units = calibration.toUnits(p);
    points.points.push_back({units.x, units.y});
  }
  return points;
}

bool drawsWhole(const StrokePoints& traced, const StrokePoints& drawn) {
  const auto [from, to] = spanOf(traced);
  const auto [drawnFrom, drawnTo] = spanOf(drawn);
  return drawnTo - drawnFrom >= wholeStrokeShare * (to - from);
}

StrokePoints withDrawnPart(const StrokePoints& traced, const StrokePoints& drawn) {
  if (traced.points.empty() || drawn.points.empty()) return drawn.points.empty() ? traced : drawn;
  if (drawsWhole(traced, drawn)) return drawn;
  const auto [drawnFrom, drawnTo] = spanOf(drawn);
  const bool increases = traced.points.front().displacement_mm < traced.points.back().displacement_mm;
  const auto isBefore = [&, low = drawnFrom, high = drawnTo](double x) {
    return increases ? x < low : x > high;
  };
  const auto isAfter = [&, low = drawnFrom, high = drawnTo](double x) {
    return increases ? x > high : x < low;
  };
  StrokePoints spliced;
  for (std::size_t i = 0; i < traced.points.size(); ++i)
    if (isBefore(traced.points[i].displacement_mm)) add(spliced, traced, i);
  for (std::size_t i = 0; i < drawn.points.size(); ++i) add(spliced, drawn, i);
  for (std::size_t i = 0; i < traced.points.size(); ++i)
    if (isAfter(traced.points[i].displacement_mm)) add(spliced, traced, i);
  return spliced;
}

}  // namespace detent::importer
