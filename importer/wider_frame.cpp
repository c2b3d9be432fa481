// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/wider_frame.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "importer/page/same_ink.h"

namespace detent::importer {
namespace {

constexpr std::size_t tail = 12;  // points of a curve that say where it leads

/// Column in which a curve's ink ends beyond the frame's right edge; empty where it does not end within `most_px` of it.
std::optional<int> inkEndsAt(const CurveTrace& curve, const Box& frame, double most_px,
                             const Raster& picture) {
  constexpr int reach = 2;  // over what a line's edge or a pale gridline takes out of it
  const int last = static_cast<int>(std::min(frame.x1 + most_px, picture.width_px - 2.0));
  const int first = static_cast<int>(frame.x1) - 3;
  const int top = static_cast<int>(frame.y0), foot = static_cast<int>(frame.y1);
  std::set<std::pair<int, int>> seen;
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int x, int y) {
    if (x < first || y < top || y > foot || !isInkOf(picture, curve.color, x, y)) return;
    if (seen.emplace(x, y).second) open.emplace_back(x, y);
  };
  for (const Point& p : curve.points_px)
    if (p.x >= first) visit(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
  int end = first;
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    end = std::max(end, x);
    if (end >= last) return {};
    for (int v = y - reach; v <= y + reach; ++v)
      for (int u = x - reach; u <= x + reach; ++u) visit(u, v);
  }
  return end;
}

bool standsLevel(const PlotFrame& frame) {
  constexpr double most_px = 1.5;  // an area cut out along rows and columns takes no more
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
  if (curve.size() <= tail) return false;
  const Point end = curve.back(), before = curve[curve.size() - 1 - tail];
  const double run = distance(end, before);
  if (!(run > 0)) return false;
  for (const double beyond_px : {5.0, 7.0, 9.0}) {
    const int x = static_cast<int>(std::lround(end.x + beyond_px * (end.x - before.x) / run));
    const int y = static_cast<int>(std::lround(end.y + beyond_px * (end.y - before.y) / run));
    bool seen = false;
    for (int v = y - reach; v <= y + reach; ++v)
      for (int u = x - reach; u <= x + reach; ++u) seen = seen || isInkOf(picture, color, u, v);
    if (!seen) return false;
  }
  return true;
}

std::optional<LocatedGraph> widenedToItsCurves(const LocatedGraph& graph,
                                               const std::vector<CurveTrace>& curves) {
  constexpr double atEdge_px = 2, mostShare = 0.2, roomShare = 0.01, leastRoom_px = 3;  // shares of the width
  constexpr double wallAlongEdge_px = 5;  // half of the thickest line
  const PlotFrame& frame = graph.frame.value;
  const Box box = frame.box();
  const Raster& picture = graph.view.raster;
  if (picture.empty() || !standsLevel(frame) || isContradicted(graph)) return {};
  bool leaves = false;
  double edge_px = box.x1;
  for (const CurveTrace& curve : curves) {
    if (curve.points_px.size() < 2) continue;
    std::vector<Point> line = curve.points_px;
    if (line.front().x > line.back().x) std::ranges::reverse(line);
    if (line.back().x < box.x1 - atEdge_px) continue;
    const auto end = inkEndsAt(curve, box, mostShare * box.width(), picture);
    if (!end) return {};
    // A wall along the edge goes on upwards, over the frame's own line.
    const double rightwards_px = line.back().x - line[line.size() - std::min(line.size(), tail + 1)].x;
    const bool alongEdge = rightwards_px < 2 && *end <= box.x1 + wallAlongEdge_px;
    leaves = leaves || (!alongEdge && goesOnBeyond(line, curve.color, picture));
    edge_px = std::max(edge_px, *end + std::max(leastRoom_px, roomShare * box.width()));
  }
  edge_px = std::min(edge_px, picture.width_px - 1.0);
  if (!leaves || edge_px <= box.x1) return {};
  LocatedGraph wider = graph;
  const double by_px = edge_px - box.x1;
  wider.frame.value.corners[1].x += by_px, wider.frame.value.corners[2].x += by_px;
  AxisReading& x = wider.axes.calibration.value.x;
  x.max += (x.max - x.min) * by_px / box.width();
  return wider;
}

}  // namespace detent::importer
