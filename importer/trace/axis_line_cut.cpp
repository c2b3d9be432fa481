// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/axis_line_cut.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

constexpr double kLeastTail = 0.05;  // share of the frame's width; shorter ones are rounded corners
// share of the frame's width, free of curves, for measuring the axis' thickness
constexpr double kLeastBare = 0.03;
// times the axis' own thickness; a curve drawn over it would be visible
constexpr double kLeastThicker = 1.12;
constexpr double kSame =
    0.35;  // share of the difference between the axis' and the curve's thickness; less means axis only
constexpr double kThickest_px = 8;  // of a curve; points farther from the axis are not on it
constexpr double kBeside = 3;       // curve widths within which a curve thickens the axis
constexpr double kColumn_px = 3;    // beside a vertical line of the plot, where the axis is thicker

/// Thickness of the x axis between two places, at columns accepted by `take` and not crossed by a vertical
/// line of the plot; nullopt for fewer than `least_px` columns.
template <class Take>
std::optional<double> axisThickness(const ColourOnArea& coverage, const PlotArea& area, double from,
                                    double to, double least_px, Take take) {
  std::vector<double> runs;
  for (int x = static_cast<int>(std::ceil(from)); x <= to; ++x)
    if (!isAtOneOf(area.columns_px, x, kColumn_px) && take(x))
      runs.push_back(coverage.across(x, area.frame.y1, false).thickness_px);
  if (static_cast<double>(runs.size()) < std::max(1.0, least_px)) return {};
  return quantileOf(runs, 0.5);
}

/// A trace on the area, from left to right.
std::vector<Point> onArea(const CurveTrace& trace, const PlotArea& area) {
  std::vector<Point> points;
  for (const Point& p : trace.points_px) points.push_back(area.fromView(p));
  if (!points.empty() && points.front().x > points.back().x) std::ranges::reverse(points);
  return points;
}

/// Marks the columns in which any curve comes near the x axis.
std::vector<char> columnsNearAxis(const std::vector<CurveTrace>& traces, const PlotArea& area,
                                  double near_px) {
  std::vector<char> near(static_cast<std::size_t>(area.raster.width_px), 0);
  for (const CurveTrace& trace : traces) {
    const std::vector<Point> points = onArea(trace, area);
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (area.frame.y1 - std::max(points[i - 1].y, points[i].y) > near_px) continue;
      const int from = std::max(0, static_cast<int>(points[i - 1].x - near_px)),
                to = std::min(area.raster.width_px - 1, static_cast<int>(points[i].x + near_px));
      for (int x = from; x <= to; ++x) near[static_cast<std::size_t>(x)] = 1;
    }
  }
  return near;
}

/// Number of points at a trace's left end that lie on the x axis; nullopt if too short.
std::optional<std::size_t> tailOnAxis(const std::vector<Point>& points, const PlotArea& area,
                                      double within_px) {
  const auto leaves =
      std::ranges::find_if(points, [&](Point p) { return std::abs(area.frame.y1 - p.y) > within_px; });
  if (leaves == points.begin() || leaves == points.end()) return {};
  if (std::prev(leaves)->x - points.front().x < kLeastTail * area.frame.width()) return {};
  return static_cast<std::size_t>(leaves - points.begin());
}

/// Number of points at a trace's left end that lie on the x axis and are only the axis.
std::size_t pointsOnAxisLine(const CurveTrace& trace, const std::vector<CurveTrace>& traces,
                             const PlotArea& area, const ColourOnArea& coverage) {
  const std::vector<Point> points = onArea(trace, area);
  std::vector<Point> clear;
  std::ranges::copy_if(points, std::back_inserter(clear),
                       [&](Point p) { return p.y < area.frame.y1 - kThickest_px; });
  const double width = area.frame.width(), thick_px = coverage.thicknessAlong(clear);
  const auto tail = tailOnAxis(points, area, 0.5 * thick_px + 1.5);
  if (!tail) return 0;
  const double from = points.front().x, to = points[*tail - 1].x;
  const double near_px = kBeside * thick_px + 4;
  const std::vector<char> near = columnsNearAxis(traces, area, near_px);
  const auto own =
      axisThickness(coverage, area, area.frame.x0 + near_px, area.frame.x1 - near_px, kLeastBare * width,
                    [&](int x) { return !near[static_cast<std::size_t>(x)]; });
  const auto here = axisThickness(coverage, area, from, to - near_px, 0, [](int) { return true; });
  if (!own || !here || *own <= 0 || thick_px < kLeastThicker * *own) return 0;
  return *here < std::lerp(*own, thick_px, kSame) ? *tail - 1 : 0;
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

void cutAlongAxisLine(std::vector<CurveTrace>& traces, const PlotScene& scene) {
  if (scene.empty()) return;
  const PlotArea& area = scene.area();
  const auto mayRunOnAxis = [&](const CurveTrace& trace) {
    return !trace.fromVector && tailOnAxis(onArea(trace, area), area, kThickest_px).has_value();
  };
  if (std::ranges::none_of(traces, mayRunOnAxis)) return;
  std::vector<std::size_t> onLine;
  for (const CurveTrace& trace : traces) {
    const ColourOnArea& coverage = scene.coverageOf(trace.color);
    onLine.push_back(
        mayRunOnAxis(trace) && coverage.distinct() ? pointsOnAxisLine(trace, traces, area, coverage) : 0);
  }
  for (std::size_t i = 0; i < traces.size(); ++i)
    if (onLine[i] > 0) dropEnd(traces[i], onLine[i], false);
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
