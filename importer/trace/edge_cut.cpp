// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/edge_cut.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace detent::importer::trace {

namespace {

constexpr double kLeastTail = 0.05;  // share of the frame's width; shorter ones are rounded corners
constexpr double kThickest_px = 8;   // of a curve; points farther from the axis are not on it

/// A trace on the area, from left to right.
std::vector<Point> onArea(const CurveTrace& trace, const PlotArea& area) {
  std::vector<Point> points;
  for (const Point& p : trace.points_px) points.push_back(area.fromView(p));
  if (!points.empty() && points.front().x > points.back().x) std::ranges::reverse(points);
  return points;
}

/// Number of points at a trace's right end without its colour: on the frame's upper or right edge, and the
/// way there over bare paper.
std::size_t pointsBeyondColour(const std::vector<Point>& points, const PlotArea& area,
                               const ColourOnArea& coverage) {
  constexpr double near_px = 3, bare = 0.3, leastBare = 0.02;  // coverage; of the frame's height
  const Box& frame = area.frame;
  const auto onEdge = [&](Point p) { return p.y - frame.y0 <= near_px || frame.x1 - p.x <= near_px; };
  const auto isBare = [&](Point p) {
    return coverage.at(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))) < bare;
  };
  const auto from = std::find_if_not(points.rbegin(), points.rend(), onEdge);
  if (from == points.rend()) return 0;
  const auto inked = std::find_if_not(from, points.rend(), isBare);
  if (inked == points.rend() || from == points.rbegin()) return 0;
  const Point edge = *std::prev(from);
  if (distance(edge, points.back()) < kLeastTail * frame.width()) return 0;
  if (distance(*inked, edge) < leastBare * frame.height()) return 0;
  return static_cast<std::size_t>(inked - points.rbegin());
}

}  // namespace

void cutAcrossToEdges(std::vector<CurveTrace>& traces, const PlotScene& scene) {
  if (scene.empty()) return;
  const PlotArea& area = scene.area();
  for (CurveTrace& trace : traces) {
    const std::vector<Point> points = onArea(trace, area);
    if (trace.fromVector || points.empty() || area.frame.x1 - points.back().x > kThickest_px) continue;
    const ColourOnArea& coverage = scene.coverageOf(trace.color);
    if (coverage.distinct()) dropEnd(trace, pointsBeyondColour(points, area, coverage), true);
  }
}

void dropEnd(CurveTrace& trace, std::size_t count, bool atRight) {
  const bool atBack = (trace.points_px.front().x > trace.points_px.back().x) != atRight;
  const auto n = static_cast<std::ptrdiff_t>(count);
  const auto dropFrom = [&](auto& values) {
    values.erase(atBack ? values.end() - n : values.begin(), atBack ? values.end() : values.begin() + n);
  };
  dropFrom(trace.points_px);
  if (!trace.width_px.empty()) dropFrom(trace.width_px);
}

}  // namespace detent::importer::trace
