// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/polyline.h"

#include <algorithm>
#include <cmath>

namespace detent::importer {

Box boundsOf(const Polyline& points) {
  Box box{points[0].x, points[0].y, points[0].x, points[0].y};
  for (Point p : points) box = box.joined({p.x, p.y, p.x, p.y});
  return box;
}

double lengthOf(const Polyline& line) { return line.empty() ? 0 : arcOf(line).back(); }

std::vector<double> arcOf(const Polyline& line) {
  std::vector<double> arc(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i) arc[i] = arc[i - 1] + distance(line[i], line[i - 1]);
  return arc;
}

double projectionOn(Point a, Point b, Point p) {
  const double squared = dot(b - a, b - a);
  return squared > 0 ? std::clamp(dot(p - a, b - a) / squared, 0.0, 1.0) : 0;
}

Point nearestOn(const Polyline& line, Point p) {
  Point best = line[0];
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point a = line[i - 1], b = line[i], nearest = a + projectionOn(a, b, p) * (b - a);
    if (distance(p, nearest) < distance(p, best)) best = nearest;
  }
  return best;
}

double twiceAreaOf(const Polyline& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) area += cross(ring[i], ring[(i + 1) % ring.size()]);
  return area;
}

Polyline withoutRepeats(const Polyline& line) {
  Polyline out;
  for (Point p : line)
    if (out.empty() || distance(out.back(), p) > 1e-9) out.push_back(p);
  return out;
}

Polyline densified(const Polyline& line, double step) {
  Polyline out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) {
      const Point a = line[i - 1], b = line[i];
      const int n = std::max(1, static_cast<int>(std::ceil(distance(a, b) / step)));
      for (int k = 1; k < n; ++k) out.push_back(a + (static_cast<double>(k) / n) * (b - a));
    }
    out.push_back(line[i]);
  }
  return out;
}

Polyline resampled(const Polyline& line, double spacing) {
  if (line.size() < 2) return line;
  const std::vector<double> arc = arcOf(line);
  const double total = arc.back();
  if (total <= 0) return {line.front(), line.back()};
  const std::size_t n = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(total / spacing)));
  Polyline out;
  out.reserve(n + 1);
  std::size_t j = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    const double s = total * static_cast<double>(i) / static_cast<double>(n);
    while (j + 2 < line.size() && arc[j + 1] < s) ++j;
    const double piece = arc[j + 1] - arc[j];
    out.push_back(line[j] +
                  (piece > 0 ? std::clamp((s - arc[j]) / piece, 0.0, 1.0) : 0) * (line[j + 1] - line[j]));
  }
  return out;
}

Polyline smoothed(const Polyline& line, double sigma) {
  const int reach = std::max(1, static_cast<int>(std::ceil(2.5 * sigma))), n = static_cast<int>(line.size());
  std::vector<double> kernel;
  for (int k = 0; k <= reach; ++k) kernel.push_back(std::exp(-0.5 * k * k / (sigma * sigma)));
  Polyline out(line.size());
  for (int i = 0; i < n; ++i) {
    const int window = std::min({reach, i, n - 1 - i});
    Point sum;
    double weight = 0;
    for (int k = -window; k <= window; ++k) {
      const double w = kernel[static_cast<std::size_t>(std::abs(k))];
      sum = sum + w * line[static_cast<std::size_t>(i + k)];
      weight += w;
    }
    out[static_cast<std::size_t>(i)] = {sum.x / weight, sum.y / weight};
  }
  return out;
}

Polyline normalsOf(const Polyline& line, int reach) {
  const int n = static_cast<int>(line.size());
  Polyline normals(line.size(), {0, -1});
  for (int i = 0; i < n; ++i) {
    const Point along = line[static_cast<std::size_t>(std::min(n - 1, i + reach))] -
                        line[static_cast<std::size_t>(std::max(0, i - reach))];
    const double length = norm(along);
    if (length > 1e-9)
      normals[static_cast<std::size_t>(i)] = {along.y / length, -along.x / length};
    else if (i > 0)
      normals[static_cast<std::size_t>(i)] = normals[static_cast<std::size_t>(i) - 1];
  }
  return normals;
}

std::vector<double> stiffened(const std::vector<double>& target, const std::vector<double>& weight,
                              double stiffness) {
  const std::size_t n = target.size();
  if (n < 3) return target;
  std::vector<double> a(n), b(n, 0), c(n, 0), x(n);  // diagonal, first and second super-diagonal, right side
  for (std::size_t i = 0; i < n; ++i) {
    a[i] = weight[i] + 1e-6;  // a weak pull to zero keeps values without weight finite
    x[i] = weight[i] * target[i];
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    a[i - 1] += stiffness;
    a[i] += 4 * stiffness;
    a[i + 1] += stiffness;
    b[i - 1] -= 2 * stiffness;
    b[i] -= 2 * stiffness;
    c[i - 1] += stiffness;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (i >= 1) {
      x[i] -= b[i - 1] * x[i - 1];
      a[i] -= b[i - 1] * b[i - 1] * a[i - 1];
      b[i] -= b[i - 1] * c[i - 1] * a[i - 1];
    }
    if (i >= 2) {
      x[i] -= c[i - 2] * x[i - 2];
      a[i] -= c[i - 2] * c[i - 2] * a[i - 2];
    }
    b[i] /= a[i];
    c[i] /= a[i];
  }
  for (std::size_t i = n; i-- > 0;) {
    x[i] /= a[i];
    if (i + 1 < n) x[i] -= b[i] * x[i + 1];
    if (i + 2 < n) x[i] -= c[i] * x[i + 2];
  }
  return x;
}

}  // namespace detent::importer
