// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/flatten.h"

#include <algorithm>
#include <cmath>

#include "importer/page/clip_line.h"

namespace detent::importer {
namespace {

/// The point of the box that is nearest to a finite point.
Point movedTo(const Box& box, Point p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return p;
  return {std::clamp(p.x, box.x0, box.x1), std::clamp(p.y, box.y0, box.y1)};
}

}  // namespace

void PathFlattener::add(Point transformed) {
  if (current_.empty())
    start_ = transformed;
  else
    addCrossings(transformed);
  last_ = transformed;
  ++pointCount_;
  const Point kept = movedTo(within_, transformed);
  if (kept == transformed || current_.empty() || current_.back() != kept) current_.push_back(kept);
}

/// Adds the points where the line to `next` crosses the edge, or the corner that it passes outside.
void PathFlattener::addCrossings(Point next) {
  const auto add = [&](Point p) {
    if (p != current_.back()) current_.push_back(p);
  };
  double from = 0, to = 1;
  if (!insideSpan(last_, next, within_, from, to))
    return add(movedTo(within_, pointBetween(last_, next, 0.5 * (from + to))));
  for (const double t : {from, to})
    if (t > 0 && t < 1) add(pointBetween(last_, next, t));
}

void PathFlattener::finish(bool closed) {
  if (current_.size() >= 2) {
    polylines_.push_back(std::move(current_));
    closed_.push_back(closed);
  }
  current_.clear();
}

void PathFlattener::moveTo(Point p) {
  finish(false);
  add(transform_(p));
}

void PathFlattener::lineTo(Point p) { add(transform_(p)); }

void PathFlattener::curveTo(Point control1, Point control2, Point end) {
  if (current_.empty()) add(transform_(control1));
  const Point a = last_, b = transform_(control1), c = transform_(control2), d = transform_(end);
  // A cubic's chord error over a step h is at most h²/8 of its second derivative, which is at most 6 times
  // the larger second difference of its control points.
  const double bend = std::max(std::hypot(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y),
                               std::hypot(b.x - 2 * c.x + d.x, b.y - 2 * c.y + d.y));
  const double wanted = std::ceil(std::sqrt(0.75 * bend / tolerance_));
  const int steps = std::isfinite(wanted) ? static_cast<int>(std::clamp(wanted, 1.0, 512.0)) : 1;
  for (int i = 1; i < steps; ++i) {
    const double t = static_cast<double>(i) / steps, s = 1 - t;
    const double wa = s * s * s, wb = 3 * s * s * t, wc = 3 * s * t * t, wd = t * t * t;
    add({wa * a.x + wb * b.x + wc * c.x + wd * d.x, wa * a.y + wb * b.y + wc * c.y + wd * d.y});
  }
  add(d);
}

void PathFlattener::close() {
  if (current_.empty()) return;
  addCrossings(start_);
  const Point start = current_.front();
  finish(true);
  last_ = start_;
  current_.push_back(start);  // a segment that follows without a move begins where the closed path began
}

std::vector<std::vector<Point>> PathFlattener::takePolylines() {
  finish(false);
  return std::move(polylines_);
}

}  // namespace detent::importer
