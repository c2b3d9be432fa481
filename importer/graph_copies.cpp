// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/graph_copies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "importer/page/polyline.h"

namespace detent::importer {
namespace {

bool sameRange(const AxisReading& a, const AxisReading& b) {
  const double slack = 0.01 * std::abs(a.max - a.min);
  return a.unit == b.unit && std::abs(a.min - b.min) <= slack && std::abs(a.max - b.max) <= slack;
}

struct Scale {
  double perMm = 1, perN = 1;
};

std::optional<Scale> scaleOf(const StrokePair& pair) {
  const auto& points = pair.press.points;
  if (points.size() < 2) return {};
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(),
                          [](CurvePoint p, CurvePoint q) { return p.displacement_mm < q.displacement_mm; });
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](CurvePoint p, CurvePoint q) { return p.force_N < q.force_N; });
  const double span_mm = right->displacement_mm - left->displacement_mm,
               span_N = high->force_N - low->force_N;
  if (!(span_mm > 0) || !(span_N > 0)) return {};
  return Scale{1 / span_mm, 1 / span_N};
}

std::vector<Point> scaled(const StrokePoints& stroke, const Scale& scale) {
  std::vector<Point> line;
  for (const CurvePoint& p : stroke.points)
    line.push_back({p.displacement_mm * scale.perMm, p.force_N * scale.perN});
  return line;
}

/// Mean distance at equal steps along `from`, so that dense stretches do not count more.
double meanDistance(const std::vector<Point>& from, const std::vector<Point>& to) {
  constexpr double step = 0.01;  // share of the span
  double sum = 0, n = 0, next = 0, travelled = 0;
  for (std::size_t i = 1; i < from.size(); ++i) {
    const Point a = from[i - 1], b = from[i];
    const double length = distance(a, b);
    for (; length > 0 && next <= travelled + length; next += step) {
      const double t = (next - travelled) / length;
      const Point p = a + t * (b - a);
      sum += distance(p, nearestOn(to, p));
      n += 1;
    }
    travelled += length;
  }
  return n > 0 ? sum / n : std::numeric_limits<double>::infinity();
}

double apart(const StrokePoints& a, const StrokePoints& b, const Scale& scale) {
  const auto p = scaled(a, scale), q = scaled(b, scale);
  return 0.5 * (meanDistance(p, q) + meanDistance(q, p));
}

}  // namespace

bool haveSameAxes(const AxisCalibration& a, const AxisCalibration& b) {
  return sameRange(a.x, b.x) && sameRange(a.y, b.y);
}

std::optional<double> distanceBetween(const StrokePair& a, const StrokePair& b) {
  const auto scale = scaleOf(a);
  if (!scale || b.press.points.size() < 2 || a.release.has_value() != b.release.has_value()) return {};
  const double press = apart(a.press, b.press, *scale);
  return a.release ? std::max(press, apart(*a.release, *b.release, *scale)) : press;
}

bool isBetterCopy(const CopyRank& a, const CopyRank& b) {
  constexpr double equallySure = 0.1;  // difference of confidence
  if (std::abs(a.confidence - b.confidence) > equallySure) return a.confidence > b.confidence;
  if (a.exact != b.exact) return a.exact;
  return a.framePixels > b.framePixels;
}

}  // namespace detent::importer
