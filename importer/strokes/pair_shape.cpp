// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/pair_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace detent::importer {
namespace {

constexpr std::size_t kCells = 200;  // along the travel

/// Mean row of a path per cell of the travel; NaN where it does not run.
std::vector<double> rowsOf(const CurvePath& path, double from_px, double to_px) {
  std::vector<double> sum(kCells, 0), n(kCells, 0);
  const auto cellOf = [&](double x) { return (x - from_px) / (to_px - from_px) * kCells; };
  for (std::size_t i = 0; i + 1 < path.points_px.size(); ++i) {
    const Point a = path.points_px[i], b = path.points_px[i + 1];
    const double ca = cellOf(a.x), cb = cellOf(b.x);
    // One sample per cell crossed, at least one per piece: sparse polylines fill every cell they pass.
    const int pieces = std::max(1, static_cast<int>(std::ceil(2 * std::abs(cb - ca))));
    for (int k = 0; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, c = std::lerp(ca, cb, t);
      if (c < 0 || c >= kCells) continue;
      sum[static_cast<std::size_t>(c)] += std::lerp(a.y, b.y, t);
      n[static_cast<std::size_t>(c)] += 1;
    }
  }
  for (std::size_t i = 0; i < kCells; ++i) sum[i] = n[i] > 0 ? sum[i] / n[i] : std::nan("");
  return sum;
}

/// A path's largest drop of force, in rows, and the column where most of it has happened: on the flat floor
/// of a valley noise decides which point is lowest.
struct Drop {
  double fall_px = 0, valley_px = 0;
};

Drop largestDrop(const CurvePath& path) {
  constexpr double over = 0.95;  // share of the drop
  Drop largest;
  const auto& points = path.points_px;
  auto peak = points.begin(), from = peak;
  for (auto p = points.begin(); p != points.end(); ++p) {
    if (p->y < peak->y) peak = p;
    if (p->y - peak->y > largest.fall_px) largest.fall_px = p->y - peak->y, from = peak;
  }
  const auto valley =
      std::find_if(from, points.end(), [&](Point p) { return p.y - from->y >= over * largest.fall_px; });
  if (valley != points.end()) largest.valley_px = valley->x;
  return largest;
}

/// Share of the mean square difference between two curves that vanishes if one is scaled in force and shifted
/// along the travel: 1 for two samples of one shape. `rest_px`: the row without force.
double sharedShape(std::vector<double> a, std::vector<double> b, double rest_px) {
  constexpr int cells = kCells, mostMoved = 20;
  for (double& y : a) y = rest_px - y;
  for (double& y : b) y = rest_px - y;
  const auto meanSquare = [&](int moved, std::optional<double> scale) {
    double aa = 0, ab = 0, bb = 0, n = 0;
    for (int i = std::max(0, -moved); i < cells - std::max(0, moved); ++i) {
      const double x = a[static_cast<std::size_t>(i + moved)], y = b[static_cast<std::size_t>(i)];
      if (!std::isfinite(x) || !std::isfinite(y)) continue;
      aa += x * x, ab += x * y, bb += y * y, n += 1;
    }
    if (!(aa > 0)) return std::numeric_limits<double>::infinity();
    const double k = scale.value_or(ab / aa);
    return std::max(0.0, bb - 2 * k * ab + k * k * aa) / n;
  };
  const double apart = meanSquare(0, 1);
  double left = apart;
  for (int moved = -mostMoved; moved <= mostMoved; ++moved) left = std::min(left, meanSquare(moved, {}));
  return apart > 0 ? 1 - left / apart : 0;
}

double gapAtTheEnds(const CurvePath& a, const CurvePath& b, const Box& room) {
  const auto inShares = [&](const CurvePath& path) {
    Polyline shares;
    for (const Point p : path.points_px) shares.push_back({p.x / room.width(), p.y / room.height()});
    return shares;
  };
  const Polyline ofA = inShares(a), ofB = inShares(b);
  const auto farEnd = [](const Polyline& line) { return *std::ranges::max_element(line, {}, &Point::x); };
  return std::min(distance(farEnd(ofA), nearestOn(ofB, farEnd(ofA))),
                  distance(farEnd(ofB), nearestOn(ofA, farEnd(ofB))));
}

}  // namespace

CurvePath::CurvePath(const CurveTrace& trace) : points_px(trace.points_px) {
  if (points_px.front().x > points_px.back().x) std::ranges::reverse(points_px);
  const auto [left, right] = std::ranges::minmax(points_px, {}, &Point::x);
  const auto [top, lowest] = std::ranges::minmax(points_px, {}, &Point::y);
  room_px = {left.x, top.y, right.x, lowest.y};
}

PairShape shapeOf(const CurvePath& a, const CurvePath& b) {
  constexpr double seen_px = 0.6;
  constexpr double farShare = 0.02, leastDropShare = 0.05;  // of the height
  constexpr std::size_t rim = kCells / 50;  // bottom-outs: a small shift there is a large difference in force
  PairShape shape;
  const Box room = a.room_px.joined(b.room_px);
  if (!(room.width() > 0 && room.height() > 0)) return shape;
  const double width_px = room.width(), height_px = room.height();
  shape.startsApart = std::abs(a.room_px.x0 - b.room_px.x0) / width_px;
  shape.startForces = std::abs(a.points_px.front().y - b.points_px.front().y) / height_px;
  shape.reachesApart = (a.room_px.x1 - b.room_px.x1) / width_px;
  shape.topsApart = (b.room_px.y0 - a.room_px.y0) / height_px;
  shape.gap = gapAtTheEnds(a, b, room);
  const double from_px = std::max(a.room_px.x0, b.room_px.x0), to_px = std::min(a.room_px.x1, b.room_px.x1);
  if (to_px - from_px < 1) return shape;  // not a pixel in common
  const std::vector<double> ofA = rowsOf(a, from_px, to_px), ofB = rowsOf(b, from_px, to_px);
  std::vector<double> higher_px;
  for (std::size_t i = rim; i < kCells - rim; ++i)
    if (std::isfinite(ofB[i] - ofA[i])) higher_px.push_back(ofB[i] - ofA[i]);
  const auto shareWhere = [&](auto holds) {
    return higher_px.empty() ? 0
                             : static_cast<double>(std::ranges::count_if(higher_px, holds)) /
                                   static_cast<double>(higher_px.size());
  };
  shape.above = shareWhere([](double px) { return px > seen_px; });
  shape.below = shareWhere([](double px) { return px < -seen_px; });
  shape.farAbove = shareWhere([&](double px) { return px > farShare * height_px; });
  shape.farBelow = shareWhere([&](double px) { return px < -farShare * height_px; });
  const Drop dropA = largestDrop(a), dropB = largestDrop(b);
  if (std::min(dropA.fall_px, dropB.fall_px) > leastDropShare * height_px) {
    shape.dropsLater = (dropA.valley_px - dropB.valley_px) / width_px;
    shape.oneShape = sharedShape(ofA, ofB, room.y1);
  }
  return shape;
}

bool onlyFalls(const CurvePath& path) {
  constexpr double rippleShare = 0.02;  // share of the fall; traced points are noisy
  // sideways: on a steep fall a small sideways error is a large one in force
  constexpr double waver_px = 1.5;
  std::vector<Point> points = path.points_px;
  std::ranges::stable_sort(points, {}, &Point::x);
  const double fall_px = points.back().y - points.front().y;
  double lowest_px = points.front().y;
  std::size_t left = 0;
  for (const Point& p : points) {
    for (; points[left].x < p.x - waver_px; ++left) lowest_px = std::max(lowest_px, points[left].y);
    if (lowest_px - p.y > rippleShare * fall_px) return false;
  }
  return true;
}

}  // namespace detent::importer
