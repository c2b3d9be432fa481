// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/walls.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "importer/page/quantile.h"
#include "importer/trace/curve_ink.h"

namespace detent::importer::trace {

namespace {

constexpr double kLeastOfCurve = 0.6;  // of the curve's thickness, for a row to be the wall's
constexpr double kMostOfCurve = 1.7;   // of it: bars and shaded areas are thicker
constexpr double kLean_px = 0.75;      // between a wall's halves: what leans more is no wall
constexpr double kThicker = 0.35;      // of it: how much more ink the wall has than the line it stands on
constexpr double kThicker_px = 0.4;    // the same, at least
constexpr double kLeastHeight = 0.05;  // of the frame's height
constexpr std::size_t kLeastRows = 6;  // that tell how thick a line is
constexpr double kHook = 4;            // widths of the line beside a wall in which a crest is the corner's
constexpr double kHook_px = 4;         // and pixels over which a path bends at a corner
constexpr double kTopReached_px = 3;   // a wall that ends so near to the frame's edge runs into it

/// A curve in area pixels, from left to right, with what its end tells.
struct Curve {
  std::vector<Point> points;
  bool reversed = false;  ///< drawn from the right
  double thickness_px = 0;

  Point end() const { return points.back(); }
};

Curve curveOf(const CurveTrace& trace, const PlotArea& area) {
  Curve curve;
  for (const Point& p : trace.points_px) curve.points.push_back(area.fromView(p));
  curve.reversed = curve.points.front().x > curve.points.back().x;
  if (curve.reversed) std::ranges::reverse(curve.points);
  return curve;
}

/// Usual thickness of a lane between two rows; nothing where they are too few.
std::optional<double> usual(const PlumbLane& lane, double y0, double y1) {
  const std::vector<double> rows = lane.rows(y0, y1);
  return rows.size() < kLeastRows ? std::nullopt : std::optional(quantileOf(rows, 0.5));
}

/// How thick the plot's own lines are that stand plumb, of which the lane may be one; 0 where the lane is none of them.
double ownLine(const CurveInkOnArea& ink, const PlotArea& area, double x, double within_px) {
  const auto isHere = [&](double column) { return std::abs(column - x) <= within_px; };
  if (std::ranges::none_of(area.columns_px, isHere)) return 0;
  std::vector<double> others;
  for (const double column : area.columns_px)
    if (!isHere(column))
      if (const auto run = usual(PlumbLane(ink, area, column), area.frame.y0 + 4, area.frame.y1 - 4))
        others.push_back(*run);
  return others.empty() ? 0 : quantileOf(others, 0.75);
}

struct Wall {
  double x = 0, foot = 0, top = 0;  ///< area px
};

/// The wall above a curve's end. `lowest`: the row below which nothing but the plot's own line may stand on the lane.
std::optional<Wall> wallAt(const Curve& curve, double lowest, const CurveInkOnArea& ink,
                           const PlotArea& area) {
  const double w = curve.thickness_px, height = area.frame.height(), margin = 1.5 * w + 2;
  const Point end = curve.end();
  if (end.y - area.frame.y0 < std::max(kLeastHeight * height, 3 * w)) return {};
  // The corner may have been cut short: the lane stands within a line's width of the end.
  const double probe = end.y - margin, probed = kLeastHeight * height;
  double x = end.x, seen = 0;
  for (double at = end.x - w - 2; at <= end.x + w + 2; at += 1)
    if (const double run = usual(PlumbLane(ink, area, at), probe - probed, probe).value_or(0); run > seen)
      seen = run, x = at;
  x = PlumbLane(ink, area, x).middle(probe - probed, probe);
  const PlumbLane lane(ink, area, x);
  const double line = std::max(usual(lane, lowest + margin, area.frame.y1 - margin).value_or(0),
                               ownLine(ink, area, x, w + 2));
  const auto isWall = [&](double thickness_px) {
    return thickness_px >= kLeastOfCurve * w && thickness_px <= kMostOfCurve * w + 1 &&
           thickness_px - line >= std::max(kThicker_px, kThicker * w);
  };
  if (!isWall(seen)) return {};
  const double top = lane.top(probe, std::max(0.5 * (seen + line), 0.8 * kLeastOfCurve * w), 2 * w + 3);
  if (end.y - top < std::max(kLeastHeight * height, 3 * w)) return {};
  // What is thicker beside the corner only is the corner.
  if (!isWall(usual(lane, top, probe).value_or(seen))) return {};
  const double half = 0.5 * (top + probe);
  if (std::abs(lane.middle(top, half) - lane.middle(half, probe)) > kLean_px) return {};
  const double atFrame = top - area.frame.y0 <= kTopReached_px + w ? area.frame.y0 : top;
  return Wall{lane.middle(top, probe), end.y, atFrame};
}

/// How many points of the curve's end lead down from a crest beside the wall. Where strokes meet on a wall, the upper one may have been
/// followed down the ink of the lower one's end; a crest as near to the wall as a few widths of the line is no peak of the button.
std::size_t pointsOfHook(const Curve& curve, double x) {
  const double near_px = kHook * curve.thickness_px + kHook_px;
  const auto& points = curve.points;
  const auto first = std::ranges::find_if(points, [&](Point p) { return p.x >= x - near_px; });
  const auto crest = std::min_element(first, points.end(), [](Point a, Point b) { return a.y < b.y; });
  if (first == points.begin() || crest == first || crest == points.end()) return 0;
  return static_cast<std::size_t>(points.end() - crest) - 1;
}

/// Takes points off the trace's right end.
void shorten(CurveTrace& trace, std::size_t count, bool reversed) {
  const auto drop = [&](auto& values) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    values.erase(reversed ? values.begin() : values.end() - n, reversed ? values.begin() + n : values.end());
  };
  drop(trace.points_px);
  if (!trace.width_px.empty()) drop(trace.width_px);
}

/// Appends the wall to the trace, at its right end.
void lengthen(CurveTrace& trace, const Wall& wall, bool reversed, const PlotArea& area) {
  std::vector<Point> rise;
  const int steps = trace.fromVector ? 1 : std::max(1, static_cast<int>(wall.foot - wall.top));
  for (int i = trace.fromVector ? 0 : 1; i <= steps; ++i)
    rise.push_back(area.toView({wall.x, wall.foot + (wall.top - wall.foot) * i / steps}));
  if (reversed) std::ranges::reverse(rise);
  const auto at = reversed ? trace.points_px.begin() : trace.points_px.end();
  if (!trace.width_px.empty()) {
    const double width_px = reversed ? trace.width_px.front() : trace.width_px.back();
    trace.width_px.insert(reversed ? trace.width_px.begin() : trace.width_px.end(), rise.size(), width_px);
  }
  trace.points_px.insert(at, rise.begin(), rise.end());
}

}  // namespace

void addLostWalls(std::vector<CurveTrace>& traces, const PlotArea& area) {
  if (traces.empty() || area.raster.empty()) return;
  const Backdrop backdrop = Backdrop::measure(area);
  std::vector<Curve> curves;
  for (const CurveTrace& trace : traces) {
    if (trace.points_px.size() < 2) return;
    curves.push_back(curveOf(trace, area));
  }
  std::vector<std::optional<Wall>> walls(traces.size());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const CurveInkOnArea ink(area, backdrop, traces[i].color);
    curves[i].thickness_px = ink.thicknessAlong(curves[i].points);
    if (!ink.distinct() || curves[i].thickness_px <= 0) continue;
    // Of strokes that end on one wall the lower one's end is the wall's foot.
    double lowest = curves[i].end().y;
    for (const Curve& other : curves)
      if (std::abs(other.end().x - curves[i].end().x) <= 2 * curves[i].thickness_px + 4)
        lowest = std::max(lowest, other.end().y);
    walls[i] = wallAt(curves[i], lowest, ink, area);
  }
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (!walls[i]) continue;
    if (const std::size_t hook = pointsOfHook(curves[i], walls[i]->x)) {
      shorten(traces[i], hook, curves[i].reversed);
      walls[i]->foot = curves[i].points[curves[i].points.size() - 1 - hook].y;
    }
    lengthen(traces[i], *walls[i], curves[i].reversed, area);
  }
}

}  // namespace detent::importer::trace
