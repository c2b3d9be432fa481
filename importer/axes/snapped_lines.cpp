// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/snapped_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace detent::importer {
namespace {

constexpr double sameFraction_px =
    // largest difference of the fractions: neighbouring marks displace the centroid of a rounded line a
    // little
    0.06;
constexpr double half_px = 0.5 + 0.03;

struct Vertex {
  double at = 0, pitch = 0;  // position of the middle value; pixels per unit of value
};

bool shareFraction(const std::vector<std::pair<double, double>>& lines) {
  const double first = lines.front().first;
  return std::all_of(lines.begin(), lines.end(), [first](const auto& l) {
    const double d = l.first - first;
    return std::abs(d - std::round(d)) <= sameFraction_px;
  });
}

/// Cuts a convex polygon by a·at + b·pitch <= c.
std::vector<Vertex> cut(const std::vector<Vertex>& polygon, double a, double b, double c) {
  std::vector<Vertex> out;
  const auto over = [&](const Vertex& v) { return a * v.at + b * v.pitch - c; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double dp = over(p), dq = over(q);
    if (dp <= 0) out.push_back(p);
    if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
      const double t = dp / (dp - dq);
      out.push_back({p.at + t * (q.at - p.at), p.pitch + t * (q.pitch - p.pitch)});
    }
  }
  return out;
}

std::optional<Vertex> centroid(const std::vector<Vertex>& polygon) {
  double area = 0, at = 0, pitch = 0;
  // Computed relative to one corner, because the polygon is tiny compared with its coordinates.
  const Vertex o = polygon.front();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const double ax = polygon[i].at - o.at, ay = polygon[i].pitch - o.pitch;
    const double bx = polygon[i + 1].at - o.at, by = polygon[i + 1].pitch - o.pitch;
    const double twice = ax * by - bx * ay;
    area += twice;
    at += twice * (ax + bx) / 3;
    pitch += twice * (ay + by) / 3;
  }
  if (std::abs(area) < 1e-18) return std::nullopt;
  return Vertex{o.at + at / area, o.pitch + pitch / area};
}

}  // namespace

std::optional<ValueLine> throughRoundedLines(const std::vector<std::pair<double, double>>& lines) {
  if (lines.size() < 3 || !shareFraction(lines)) return std::nullopt;
  double low = lines.front().second, high = low;
  for (const auto& [x, v] : lines) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (!(high > low)) return std::nullopt;
  const auto [first, last] = std::minmax_element(
      lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  // Values are scaled to -1..1, so that both coordinates of the polygon are in pixels.
  const double middle = 0.5 * (low + high), span = 0.5 * (high - low);
  const double at = 0.5 * (first->first + last->first), pitch = 0.5 * (last->first - first->first);
  std::vector<Vertex> polygon{
      {at - 2, pitch - 2}, {at + 2, pitch - 2}, {at + 2, pitch + 2}, {at - 2, pitch + 2}};
  for (const auto& [x, v] : lines) {
    const double u = (v - middle) / span;
    polygon = cut(polygon, 1, u, x + half_px);
    if (polygon.size() >= 3) polygon = cut(polygon, -1, -u, -(x - half_px));
    if (polygon.size() < 3) return std::nullopt;
  }
  const auto center = centroid(polygon);
  if (!center || center->pitch == 0) return std::nullopt;
  return ValueLine{middle - span * center->at / center->pitch, span / center->pitch};
}

}  // namespace detent::importer
