// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/flatten.h"

#include <algorithm>
#include <cmath>

namespace detent::importer {

void PathFlattener::add(Point transformed) {
  current_.push_back(transformed);
  ++pointCount_;
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
  const Point a = current_.back(), b = transform_(control1), c = transform_(control2), d = transform_(end);
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
  const Point start = current_.front();
  finish(true);
  current_.push_back(start);  // a segment that follows without a move begins where the closed path began
}

std::vector<std::vector<Point>> PathFlattener::takePolylines() {
  finish(false);
  return std::move(polylines_);
}

}  // namespace detent::importer
