// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/wider_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "importer/page/same_colour.h"

namespace detent::importer {
namespace {

constexpr std::size_t tail = 12;  // last points of a curve, from which its direction follows

/// Extent of a curve's pixels.
struct Reach {
  int right_px = 0, top_px = 0;
};

/// End of the pixels that continue a curve beyond the frame's right edge and, if `most_px.y` is above 0, its
/// upper one: its own pixels, or those of curves that cover it. Empty if they do not end within `most_px`.
std::optional<Reach> pixelsEndAt(const CurveTrace& curve, const std::vector<CurveTrace>& all,
                                 const Box& frame, Point most_px, const Raster& picture) {
  constexpr int reach = 2;  // width that the edge of a line or a pale gridline may interrupt
  const int last = static_cast<int>(std::min(frame.x1 + most_px.x, picture.width_px - 2.0));
  const int first = static_cast<int>(frame.x1) - 3, below = static_cast<int>(frame.y0) + 3;
  const bool upwards = most_px.y > 0;
  const int top = static_cast<int>(upwards ? std::max(frame.y0 - most_px.y, 1.0) : frame.y0);
  const int bottom = static_cast<int>(frame.y1);
  const auto isBeyond = [&](int x, int y) { return x >= first || (upwards && y <= below); };
  std::set<std::pair<int, int>> seen;
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int x, int y) {
    if (!isBeyond(x, y) || y < top || y > bottom) return;
    if (std::ranges::none_of(all,
                             [&](const CurveTrace& each) { return hasColour(picture, each.color, x, y); }))
      return;
    if (seen.emplace(x, y).second) open.emplace_back(x, y);
  };
  for (const Point& p : curve.points_px)
    visit(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
  Reach ends{first, static_cast<int>(frame.y0)};
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    ends.right_px = std::max(ends.right_px, x), ends.top_px = std::min(ends.top_px, y);
    if (x >= last || (upwards && (y <= top || x <= frame.x0))) return {};
    for (int v = y - reach; v <= y + reach; ++v)
      for (int u = x - reach; u <= x + reach; ++u) visit(u, v);
  }
  return ends;
}

/// Returns true if connected pixels lie to the right of a curve's end and above it: a bottom-out that begins
/// just beyond the edge, not a straight continuation of the horizontal line that arrived there.
bool turnsBeyond(Point end, Rgb color, const Raster& picture) {
  // distance to the right of the curve's end; the frame's own line ends before it
  constexpr int nearest_px = 4, farthest_px = 14;
  constexpr int riseHeight_px = 12;
  const int x0 = static_cast<int>(std::lround(end.x)), y0 = static_cast<int>(std::lround(end.y));
  std::set<std::pair<int, int>> seen;
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int x, int y) {
    if (x < x0 || x > x0 + farthest_px || y > y0 + 2 || y < y0 - riseHeight_px) return;
    if (hasColour(picture, color, x, y) && seen.emplace(x, y).second) open.emplace_back(x, y);
  };
  for (int y = y0 - 2; y <= y0 + 2; ++y) visit(x0, y);
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    if (x >= x0 + nearest_px && y <= y0 - riseHeight_px) return true;
    for (int v = y - 1; v <= y + 1; ++v)
      for (int u = x - 1; u <= x + 1; ++u) visit(u, v);
  }
  return false;
}

/// Smallest distance in pixels between neighbouring tick labels; 0 if fewer than two were read.
double stepOf(const AxisReading& axis) {
  std::vector<double> at;
  for (const TickLabel& tick : axis.ticks)
    if (tick.used) at.push_back(tick.position_px);
  std::ranges::sort(at);
  double step = 0;
  for (std::size_t i = 1; i < at.size(); ++i)
    if (step <= 0 || at[i] - at[i - 1] < step) step = at[i] - at[i - 1];
  return step;
}

/// Row of the last number that was read above the frame; the frame's edge if there is none. Text over the
/// plot may hide gridlines and curves, but not the numbers beside it.
double lastNumberAbove_px(const AxisReading& y, const Box& frame) {
  double last_px = frame.y0;
  for (const TickLabel& tick : y.ticks)
    if (tick.used) last_px = std::min(last_px, tick.position_px);
  return last_px;
}

bool standsLevel(const PlotFrame& frame) {
  // the edge of an area that was masked along rows and columns covers no more
  constexpr double most_px = 1.5;
  const auto& [topLeft, topRight, bottomRight, bottomLeft] = frame.corners;
  return std::max({std::abs(topLeft.y - topRight.y), std::abs(bottomLeft.y - bottomRight.y),
                   std::abs(topLeft.x - bottomLeft.x), std::abs(topRight.x - bottomRight.x)}) <= most_px;
}

bool isContradicted(const LocatedGraph& graph) {
  return std::ranges::any_of(
      graph.axes.remarks, [](const Remark& remark) { return remark.code == RemarkCode::labelContradicts; });
}

}  // namespace

bool goesOnBeyond(const std::vector<Point>& curve, Rgb color, const Raster& picture) {
  constexpr int reach = 2;
  if (curve.size() < 2) return false;
  // The points of a document's path may lie far apart.
  std::size_t from = curve.size() - 1;
  while (from > 0 && distance(curve[from], curve.back()) < tail) --from;
  const Point end = curve.back(), before = curve[from];
  const double run = distance(end, before);
  if (!(run > 0)) return false;
  const auto isStraightOn = [&](double beyond_px) {
    const int x = static_cast<int>(std::lround(end.x + beyond_px * (end.x - before.x) / run));
    const int y = static_cast<int>(std::lround(end.y + beyond_px * (end.y - before.y) / run));
    for (int v = y - reach; v <= y + reach; ++v)
      for (int u = x - reach; u <= x + reach; ++u)
        if (hasColour(picture, color, u, v)) return true;
    return false;
  };
  constexpr std::array beyond_px{5.0, 7.0, 9.0};
  return std::ranges::all_of(beyond_px, isStraightOn) || turnsBeyond(end, color, picture);
}

std::optional<LocatedGraph> widenedToItsCurves(const LocatedGraph& graph,
                                               const std::vector<CurveTrace>& curves) {
  constexpr double atEdge_px = 2, mostShare = 0.2, roomShare = 0.01, leastRoom_px = 3;  // shares of the width
  constexpr double lineAlongEdge_px = 5;  // half of the thickest line
  constexpr double farBeyond_px = 9;
  constexpr double lineEnd_px = 5;  // px beyond the line at which an axis ends
  const PlotFrame& frame = graph.frame.value;
  const Box box = frame.box();
  const Raster& picture = graph.view.raster;
  if (picture.empty() || !standsLevel(frame) || isContradicted(graph)) return {};
  const AxisCalibration& axes = graph.axes.calibration.value;
  // A plot that is cut at the end of its curves ends before the next number, which is not printed.
  const double last_px = lastNumberAbove_px(axes.y, box);
  const Point most_px{std::max(mostShare * box.width(), stepOf(axes.x)),
                      std::max(stepOf(axes.y), box.y0 - last_px + lineEnd_px)};
  const double room_px = std::max(leastRoom_px, roomShare * box.width());
  bool leaves = false;
  Box widened = box;
  for (const CurveTrace& curve : curves) {
    if (curve.points_px.size() < 2) continue;
    std::vector<Point> line = curve.points_px;
    if (line.front().x > line.back().x) std::ranges::reverse(line);
    const bool atRight = line.back().x >= box.x1 - atEdge_px, atTop = line.back().y <= box.y0 + atEdge_px;
    if (!atRight && !atTop) continue;
    auto end = pixelsEndAt(curve, curves, box, most_px, picture);
    if (!end && atRight) end = pixelsEndAt(curve, curves, box, {most_px.x, 0}, picture);
    if (!end) return {};
    // A bottom-out along the edge continues upwards, over the frame's own line.
    const double rightwards_px = line.back().x - line[line.size() - std::min(line.size(), tail + 1)].x;
    const bool alongEdge =
        atRight && rightwards_px < 2 && end->right_px <= box.x1 + lineAlongEdge_px && end->top_px >= box.y0;
    // a document's path is known beyond the frame
    const bool drawnBeyond = line.back().x > box.x1 + farBeyond_px;
    const bool goesOn = !alongEdge && goesOnBeyond(line, curve.color, picture);
    leaves = leaves || drawnBeyond || goesOn;
    if (atTop && goesOn && last_px < box.y0) widened.y0 = std::min(widened.y0, last_px - leastRoom_px);
    if (atRight || end->right_px > box.x1) widened.x1 = std::max(widened.x1, end->right_px + room_px);
    if (end->top_px < box.y0 - atEdge_px) widened.y0 = std::min(widened.y0, end->top_px - room_px);
  }
  widened.x1 = std::min(widened.x1, picture.width_px - 1.0), widened.y0 = std::max(widened.y0, 0.0);
  if (!leaves || (widened.x1 <= box.x1 && widened.y0 >= box.y0)) return {};
  LocatedGraph wider = graph;
  auto& [topLeft, topRight, bottomRight, bottomLeft] = wider.frame.value.corners;
  const double right_px = widened.x1 - box.x1, up_px = box.y0 - widened.y0;
  topRight.x += right_px, bottomRight.x += right_px;
  topLeft.y -= up_px, topRight.y -= up_px;
  AxisReading &x = wider.axes.calibration.value.x, &y = wider.axes.calibration.value.y;
  x.max += (x.max - x.min) * right_px / box.width();
  y.max += (y.max - y.min) * up_px / box.height();
  return wider;
}

}  // namespace detent::importer
