// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/clip_line.h"

#include <algorithm>

namespace detent::importer {

// After Liang and Barsky, ACM TOG 3 (1984).
bool insideSpan(Point a, Point b, const Box& box, double& from, double& to) {
  from = 0, to = 1;
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double p[4] = {-dx, dx, -dy, dy};
  const double q[4] = {a.x - box.x0, box.x1 - a.x, a.y - box.y0, box.y1 - a.y};
  for (int i = 0; i < 4; ++i) {
    if (p[i] == 0) {
      if (q[i] < 0) return false;
      continue;
    }
    const double t = q[i] / p[i];
    if (p[i] < 0) {
      from = std::max(from, t);
    } else {
      to = std::min(to, t);
    }
  }
  return from <= to;
}

Point pointBetween(Point a, Point b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

std::vector<Polyline> clippedLine(const Polyline& line, const Box& box) {
  std::vector<Polyline> parts;
  bool open = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    double from = 0, to = 1;
    if (!insideSpan(line[i - 1], line[i], box, from, to)) {
      open = false;
      continue;
    }
    if (!open || from > 0) parts.push_back({pointBetween(line[i - 1], line[i], from)});
    parts.back().push_back(pointBetween(line[i - 1], line[i], to));
    open = to >= 1;
  }
  return parts;
}

}  // namespace detent::importer
