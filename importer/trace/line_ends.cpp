// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/line_ends.h"

#include <algorithm>
#include <cmath>

namespace detent::importer::trace {

namespace {

constexpr double kEndStep_px = 0.5;

/// Unit direction of the line at its last point, from the last few pixels.
Point directionAtEnd(const std::vector<Point>& points, double over_px) {
  const Point last = points.back();
  for (std::size_t i = points.size() - 1; i-- > 0;) {
    const double length = distance(last, points[i]);
    if (length >= over_px || (i == 0 && length > 0)) return (1 / length) * (last - points[i]);
  }
  return {1, 0};
}

/// Distance beyond the last point (negative: before it) at which the coverage ends, along the line.
double coverageBeyondEnd(const std::vector<Point>& points, Point direction, const LineProfile& profile,
                         const CurveField& field) {
  const double reach = profile.width_px + 4;
  const double level = std::min(1.0, profile.width_px / profile.blur_px);
  const Point normal{-direction.y, direction.x};
  double inked = 0;
  for (double t = -reach; t <= reach; t += kEndStep_px) {
    double across = 0;
    for (double n : {-0.25, 0.0, 0.25}) {
      const Point p = points.back() + t * direction + (n * profile.width_px) * normal;
      across = std::max(across, static_cast<double>(field.own.sample(p.x, p.y)));
    }
    inked += std::min(1.0, across / level) * kEndStep_px;
    if (across < 0.1 * level && t > 0) break;
  }
  return inked - reach;
}

void cutBack(std::vector<Point>& points, std::vector<double>& weight, double by) {
  while (points.size() > 2 && by > 0) {
    Point& last = points.back();
    const Point before = points[points.size() - 2];
    const double piece = distance(last, before);
    if (piece > by) {
      last = last + (by / piece) * (before - last);
      return;
    }
    by -= piece;
    points.pop_back();
    weight.pop_back();
  }
}

/// The distance from p along d to the frame's edge; infinite if it is not met.
double distanceToEdge(Point p, Point d, const Box& frame) {
  double nearest = INFINITY;
  const auto meet = [&](double position, double speed, double low, double high) {
    if (speed > 1e-6) nearest = std::min(nearest, (high - position) / speed);
    if (speed < -1e-6) nearest = std::min(nearest, (low - position) / speed);
  };
  meet(p.x, d.x, frame.x0, frame.x1);
  meet(p.y, d.y, frame.y0, frame.y1);
  return nearest;
}

void finishLastEnd(CentreLine& line, const CurveField& field, const Box& frame) {
  const LineProfile& profile = line.profile;
  if (line.points.size() < 3) return;
  const Point direction = directionAtEnd(line.points, 3 + profile.width_px);
  const double beyond = coverageBeyondEnd(line.points, direction, profile, field);
  const double toEdge = distanceToEdge(line.points.back(), direction, frame);
  if (beyond >= toEdge - profile.width_px - 1) {  // drawn into the frame's edge: it continues beyond the plot
    if (toEdge > 0 && toEdge < 3 * profile.width_px + 6) {
      line.points.push_back(line.points.back() + toEdge * direction);
      line.weight.push_back(line.weight.back());
    }
    return;
  }
  // A cap extends half a width beyond the end (round, square) or not at all (butt); a quarter is off by at
  // most a quarter.
  const double move = beyond - 0.25 * profile.width_px;
  if (move < 0) {
    cutBack(line.points, line.weight, -move);
  } else if (move > 0.25) {
    line.points.push_back(line.points.back() + move * direction);
    line.weight.push_back(line.weight.back());
  }
}

/// Cuts points outside the frame and adds a point where the line crosses the edge.
void clipToFrame(CentreLine& line, const Box& frame) {
  const auto inside = [&](Point p) { return frame.contains(p); };
  std::size_t first = 0, last = line.points.size();
  while (first < last && !inside(line.points[first])) ++first;
  while (last > first && !inside(line.points[last - 1])) --last;
  std::vector<Point> points;
  std::vector<double> weight;
  const auto crossing = [&](Point in, Point out) {
    const double d = distance(out, in);
    const Point direction = (1 / d) * (out - in);
    return in + std::min(d, distanceToEdge(in, direction, frame)) * direction;
  };
  for (std::size_t i = first; i < last; ++i) {
    if (i == first && first > 0) {
      points.push_back(crossing(line.points[i], line.points[i - 1]));
      weight.push_back(line.weight[i]);
    }
    // In between, only rounding leaves the frame (a steep stretch on its edge); such points are moved to the
    // edge.
    points.push_back(
        {std::clamp(line.points[i].x, frame.x0, frame.x1), std::clamp(line.points[i].y, frame.y0, frame.y1)});
    weight.push_back(line.weight[i]);
    if (i + 1 == last && last < line.points.size()) {
      points.push_back(crossing(line.points[i], line.points[last]));
      weight.push_back(line.weight[i]);
    }
  }
  line.points = std::move(points);
  line.weight = std::move(weight);
}

}  // namespace

void finishEnds(CentreLine& line, const CurveField& field, const Box& frame) {
  finishLastEnd(line, field, frame);
  std::reverse(line.points.begin(), line.points.end());
  std::reverse(line.weight.begin(), line.weight.end());
  finishLastEnd(line, field, frame);
  std::reverse(line.points.begin(), line.points.end());
  std::reverse(line.weight.begin(), line.weight.end());
  clipToFrame(line, frame);
}

}  // namespace detent::importer::trace
