// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/strokes/closed_loops.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "importer/page/polyline.h"
#include "importer/strokes/legend.h"

namespace detent::importer {

namespace {

using Indices = std::vector<std::size_t>;

/// A trace from left to right, with its bounding box.
struct CurvePath {
  std::vector<Point> points_px;
  Box room_px;
};

CurvePath pathOf(const CurveTrace& trace) {
  CurvePath path{trace.points_px, {}};
  std::ranges::stable_sort(path.points_px, {}, &Point::x);
  const auto [top, lowest] = std::ranges::minmax_element(path.points_px, {}, &Point::y);
  path.room_px = {path.points_px.front().x, top->y, path.points_px.back().x, lowest->y};
  return path;
}

/// Row of the path at a column, interpolated; beyond its ends the row of the end.
double rowAt(const CurvePath& path, double column_px) {
  const auto right = std::ranges::lower_bound(path.points_px, column_px, {}, &Point::x);
  if (right == path.points_px.begin()) return right->y;
  if (right == path.points_px.end()) return path.points_px.back().y;
  const Point a = *std::prev(right), b = *right;
  return a.x < b.x ? std::lerp(a.y, b.y, (column_px - a.x) / (b.x - a.x)) : b.y;
}

/// The highest point: where a stroke meets the bottom-out.
Point tipOf(const CurvePath& path) { return *std::ranges::min_element(path.points_px, {}, &Point::y); }

/// Largest allowed distances of two paths' ends, as shares of their common bounding box. On a bottom-out the
/// visible tip depends on the line that covers the other one; at rest, where all curves begin, more of a line
/// is covered.
struct Apart {
  double atRest, across, along;
};

/// Returns true if both paths cover the same columns and have the same tip.
bool endTogether(const CurvePath& a, const CurvePath& b, Apart most) {
  const Box joinedRoom = a.room_px.joined(b.room_px);
  const Point tipA = tipOf(a), tipB = tipOf(b);
  const double across_px = most.across * joinedRoom.width(), along_px = most.along * joinedRoom.height();
  return std::abs(a.room_px.x0 - b.room_px.x0) <= most.atRest * joinedRoom.width() &&
         std::abs(a.room_px.x1 - b.room_px.x1) <= across_px && std::abs(tipA.x - tipB.x) <= across_px &&
         std::abs(tipA.y - tipB.y) <= along_px;
}

/// Returns true if `upper` lies above `lower` wherever they separate, and they are separate over most of
/// their length.
bool enclose(const CurvePath& upper, const CurvePath& lower) {
  constexpr int columns = 100;
  constexpr double clear = 0.01, mostBelow = 0.02, leastAbove = 0.5;  // the first of the height
  const Box joinedRoom = upper.room_px.joined(lower.room_px);
  const double clear_px = std::max(1.0, clear * joinedRoom.height());
  int above = 0, below = 0;
  for (int i = 0; i < columns; ++i) {
    const double column_px = joinedRoom.x0 + (i + 0.5) / columns * joinedRoom.width();
    const double apart_px = rowAt(lower, column_px) - rowAt(upper, column_px);
    above += apart_px > clear_px;
    below += apart_px < -clear_px;
  }
  return above >= leastAbove * columns && below <= mostBelow * columns;
}

/// Returns true if the ends lie far apart. A release begins where the press ended.
bool endFarApart(const CurvePath& a, const CurvePath& b) {
  constexpr double farShare = 0.1;  // of the width that both take together
  return std::abs(a.room_px.x1 - b.room_px.x1) > farShare * a.room_px.joined(b.room_px).width();
}

/// Smaller of the shares of common columns in which either curve lies clearly above the other; 0 if they do
/// not cross.
double crossedShare(const CurvePath& a, const CurvePath& b) {
  constexpr int columns = 100;
  constexpr double clear = 0.02;  // share of the height
  const double height_px = a.room_px.joined(b.room_px).height();
  const double from_px = std::max(a.room_px.x0, b.room_px.x0), to_px = std::min(a.room_px.x1, b.room_px.x1);
  int above = 0, below = 0;
  for (int i = 0; i < columns; ++i) {
    const double column_px = std::lerp(from_px, to_px, (i + 0.5) / columns);
    const double apart_px = rowAt(b, column_px) - rowAt(a, column_px);
    above += apart_px > clear * height_px;
    below += apart_px < -clear * height_px;
  }
  return to_px > from_px ? std::min(above, below) / static_cast<double>(columns) : 0;
}

/// Smaller distance of a far end from the other line, as a share of their common bounding box. Among measured
/// switches no release begins farther than 0.007 from its press
/// (docs/develop/decisions/0809-several-curves-in-one-colour.md).
double gapOfPaths(const CurvePath& a, const CurvePath& b) {
  const Box joinedRoom = a.room_px.joined(b.room_px);
  const auto inShares = [&](const CurvePath& path) {
    Polyline shares;
    for (const Point& p : path.points_px)
      shares.push_back({p.x / joinedRoom.width(), p.y / joinedRoom.height()});
    return shares;
  };
  if (joinedRoom.width() <= 0 || joinedRoom.height() <= 0) return 0;
  const Polyline ofA = inShares(a), ofB = inShares(b);
  return gapAtTheEnds(ofA, ofA.back(), ofB, ofB.back());
}

/// Returns true if both begin and end in one point, as press and release of one switch do but two presses do
/// not: of 238 pairs of drawn presses none ended within 0.03 of each other, of 550 switches 523 within 0.01.
bool endInOnePoint(const CurvePath& a, const CurvePath& b) {
  constexpr Apart closed{0.03, 0.01, 0.025};
  constexpr double mostGap = 0.005;  // share of their common bounding box
  return endTogether(a, b, closed) && gapOfPaths(a, b) <= mostGap;
}

/// Returns true if the curves cross more than two strokes of one switch do. Strokes of a key with two snaps
/// also cross, along part of the release near the common end.
bool cross(const CurvePath& a, const CurvePath& b) {
  constexpr double least = 0.08,
                   ofTwoSnaps = 0.28;  // share of the columns; 17 drawn keys with two snaps have 0.23 at most
  return crossedShare(a, b) > (endInOnePoint(a, b) ? ofTwoSnaps : least);
}

}  // namespace

double gapAtTheEnds(const Polyline& a, Point endOfA, const Polyline& b, Point endOfB) {
  return std::min(distance(endOfA, nearestOn(b, endOfA)), distance(endOfB, nearestOn(a, endOfB)));
}

bool onlyFalls(const CurveTrace& trace) {
  constexpr double rippleShare = 0.02;  // share of the fall; traced points are noisy
  // sideways: on a steep fall a small sideways error is a large one in force
  constexpr double waver_px = 1.5;
  const CurvePath path = pathOf(trace);
  const std::vector<Point>& points = path.points_px;
  const double fall_px = points.back().y - points.front().y;
  double lowest_px = points.front().y;
  std::size_t left = 0;
  for (const Point& p : points) {
    for (; points[left].x < p.x - waver_px; ++left) lowest_px = std::max(lowest_px, points[left].y);
    if (lowest_px - p.y > rippleShare * fall_px) return false;
  }
  return true;
}

std::vector<Indices> closedLoops(const std::vector<CurveTrace>& traces, const Indices& drawn) {
  constexpr Apart together{0.03, 0.015, 0.04};
  constexpr Apart nearby{0.05, 0.05, 0.1};  // another end nearby makes it doubtful which curves end together
  Indices strokes;
  std::ranges::copy_if(drawn, std::back_inserter(strokes),
                       [&](std::size_t i) { return !onlyFalls(traces[i]); });
  std::vector<CurvePath> paths;
  for (const std::size_t i : strokes) paths.push_back(pathOf(traces[i]));
  std::vector<Indices> loops;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    Indices partners;
    for (std::size_t j = 0; j < strokes.size(); ++j)
      if (j != i && endTogether(paths[i], paths[j], nearby)) partners.push_back(j);
    if (partners.size() != 1) return {};
    const std::size_t j = partners.front();
    if (j < i) continue;  // already seen from the other curve
    if (!endTogether(paths[i], paths[j], together)) return {};
    if (!mayBeOnePair(traces[strokes[i]].label, traces[strokes[j]].label)) return {};
    if (enclose(paths[i], paths[j]))
      loops.push_back({strokes[i], strokes[j]});
    else if (enclose(paths[j], paths[i]))
      loops.push_back({strokes[j], strokes[i]});
    else
      return {};
  }
  return loops;
}

bool closeInOnePoint(const CurveTrace& first, const CurveTrace& second) {
  const CurvePath a = pathOf(first), b = pathOf(second);
  return endInOnePoint(a, b) && (enclose(a, b) || enclose(b, a));
}

std::vector<Indices> pressesApart(const std::vector<CurveTrace>& traces, const Indices& drawn) {
  constexpr double leastWidth = 0.4;  // of the widest curve: shorter ones are marks
  constexpr double leastGap = 0.02;   // of the bounding box of two of them
  std::vector<CurvePath> paths;
  double widest_px = 0;
  for (const std::size_t i : drawn) {
    if (onlyFalls(traces[i])) return {};
    paths.push_back(pathOf(traces[i]));
    widest_px = std::max(widest_px, paths.back().room_px.width());
  }
  std::vector<Indices> apart;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (paths[i].room_px.width() < leastWidth * widest_px) return {};
    for (std::size_t j = 0; j < i; ++j) {
      // With only two curves, the one that ends early may be a release that was traced incompletely.
      const bool endApart =
          drawn.size() > 2 && (endFarApart(paths[i], paths[j]) || gapOfPaths(paths[i], paths[j]) > leastGap);
      if (traces[drawn[i]].color == traces[drawn[j]].color || !(endApart || cross(paths[i], paths[j])))
        return {};
    }
    apart.push_back({drawn[i]});
  }
  return apart;
}

}  // namespace detent::importer
