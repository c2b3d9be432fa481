// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/follow_drawn.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "importer/trace/curve_colour.h"

namespace detent::importer {
namespace {

using trace::Color3, trace::colorAt;

constexpr double offsetStep_px = 0.5;
constexpr double leastMarkContrast = 24;  // of 442; less is paper
// of coverage at the end of the reach; the drawn line is probably close
constexpr double awayCost = 0.12;
constexpr double bendCost = 0.06;        // of coverage per half pixel from one point to the next, squared
constexpr int steepest = 2;              // half pixels from one point to the next
constexpr double centreWithin_px = 2.5;  // coverage of one line
constexpr double clearCoverage = 0.3;    // coverage

double distance(Color3 a, Color3 b) { return norm(a - b); }

Point mix(Point a, Point b, double t) { return a + t * (b - a); }

std::vector<Point> withoutRepeatedPoints(const std::vector<Point>& points) {
  std::vector<Point> out;
  for (const Point& p : points)
    if (std::isfinite(p.x) && std::isfinite(p.y) && (out.empty() || distance(out.back(), p) > 1e-6))
      out.push_back(p);
  return out;
}

// Centripetal Catmull-Rom spline (Yuksel, Schaefer, Keyser 2011): no loops or overshoot with uneven points.
Point onSpline(const std::array<Point, 4>& p, double share) {
  std::array<double, 4> t{};
  for (std::size_t i = 1; i < 4; ++i) t[i] = t[i - 1] + std::max(std::sqrt(distance(p[i - 1], p[i])), 1e-6);
  const double at = t[1] + share * (t[2] - t[1]);
  const auto between = [&](Point a, Point b, double from, double to) {
    return mix(a, b, (at - from) / (to - from));
  };
  const Point a1 = between(p[0], p[1], t[0], t[1]), a2 = between(p[1], p[2], t[1], t[2]),
              a3 = between(p[2], p[3], t[2], t[3]);
  const Point b1 = between(a1, a2, t[0], t[2]), b2 = between(a2, a3, t[1], t[3]);
  return between(b1, b2, t[1], t[2]);
}

std::vector<Point> smoothLine(const std::vector<Point>& drawn, double spacing_px) {
  std::vector<Point> line;
  for (std::size_t i = 0; i + 1 < drawn.size(); ++i) {
    const Point before = i > 0 ? drawn[i - 1] : mix(drawn[1], drawn[0], 2);
    const Point after = i + 2 < drawn.size() ? drawn[i + 2] : mix(drawn[i], drawn[i + 1], 2);
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(distance(drawn[i], drawn[i + 1]) / spacing_px)));
    for (int k = 0; k < pieces; ++k)
      line.push_back(onSpline({before, drawn[i], drawn[i + 1], after}, static_cast<double>(k) / pieces));
  }
  line.push_back(drawn.back());
  return line;
}

Point normalAt(const std::vector<Point>& line, std::size_t i) {
  const Point a = line[i > 2 ? i - 3 : 0], b = line[std::min(i + 3, line.size() - 1)];
  const double length = distance(a, b);
  return length > 0 ? Point{-(b.y - a.y) / length, (b.x - a.x) / length} : Point{0, 1};
}

// Bilinear; beyond the picture its edge continues.
Color3 colorBetween(const Raster& raster, Point p) {
  const double x = std::clamp(p.x, 0.0, raster.width_px - 1.0),
               y = std::clamp(p.y, 0.0, raster.height_px - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, raster.width_px - 1), y1 = std::min(y0 + 1, raster.height_px - 1);
  const auto u = static_cast<float>(x - x0), v = static_cast<float>(y - y0);
  const Color3 above = (1 - u) * colorAt(raster, x0, y0) + u * colorAt(raster, x1, y0);
  const Color3 below = (1 - u) * colorAt(raster, x0, y1) + u * colorAt(raster, x1, y1);
  return (1 - v) * above + v * below;
}

/// Colours across the line: one row per point of the line, one column per offset.
struct Band {
  std::size_t rows = 0, columns = 0;
  std::vector<Color3> colors;
  const Color3& at(std::size_t row, std::size_t column) const { return colors[row * columns + column]; }
  double offset_px(std::size_t column) const {
    return offsetStep_px * (static_cast<double>(column) - 0.5 * static_cast<double>(columns - 1));
  }
};

Band bandAlong(const Raster& raster, const std::vector<Point>& line, double reach_px) {
  Band band;
  band.rows = line.size();
  band.columns = 2 * static_cast<std::size_t>(std::ceil(reach_px / offsetStep_px)) + 1;
  band.colors.reserve(band.rows * band.columns);
  for (std::size_t row = 0; row < band.rows; ++row) {
    const Point n = normalAt(line, row);
    for (std::size_t column = 0; column < band.columns; ++column) {
      const double o = band.offset_px(column);
      band.colors.push_back(colorBetween(raster, {line[row].x + o * n.x, line[row].y + o * n.y}));
    }
  }
  return band;
}

Color3 medianOf(std::vector<Color3> colors) {
  const auto middle = colors.begin() + static_cast<std::ptrdiff_t>(colors.size() / 2);
  const auto median = [&](float Color3::*part) {
    std::nth_element(colors.begin(), middle, colors.end(),
                     [part](Color3 a, Color3 b) { return a.*part < b.*part; });
    return (*middle).*part;
  };
  return {median(&Color3::r), median(&Color3::g), median(&Color3::b)};
}

/// Coverage of each colour by the line: 1 the line, 0 the paper. The line's colour is the one that differs
/// most from the paper near the middle of all rows; other colours count by their similarity.
std::vector<double> coverageOf(const Band& band) {
  const Color3 paper = medianOf(band.colors);
  std::vector<Color3> strongest;
  for (std::size_t row = 0; row < band.rows; ++row) {
    Color3 best = paper;
    double most = leastMarkContrast;
    for (std::size_t column = 0; column < band.columns; ++column) {
      const double away =
          1 - awayCost * std::abs(band.offset_px(column)) / std::max(-band.offset_px(0), 1e-9);
      const double d = away * distance(band.at(row, column), paper);
      if (d > most) most = d, best = band.at(row, column);
    }
    if (most > leastMarkContrast) strongest.push_back(best);
  }
  std::vector<double> coverage(band.colors.size(), 0);
  if (strongest.empty()) return coverage;
  const Color3 color = medianOf(std::move(strongest));
  const double contrast = distance(color, paper);
  if (contrast < leastMarkContrast) return coverage;
  for (std::size_t i = 0; i < coverage.size(); ++i)
    coverage[i] = std::clamp(1 - distance(band.colors[i], color) / contrast, 0.0, 1.0);
  return coverage;
}

/// The path of offsets with the most coverage for the least bending (dynamic programming).
std::vector<std::size_t> bestPath(const Band& band, const std::vector<double>& coverage) {
  const std::size_t columns = band.columns;
  std::vector<double> cost(columns, 0), next(columns);
  std::vector<std::uint8_t> from(band.rows * columns, 0);
  const double reach = std::max(-band.offset_px(0), 1e-9);
  for (std::size_t row = 0; row < band.rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double away = band.offset_px(column) / reach;
      const double own = awayCost * away * away - coverage[row * columns + column];
      double best = INFINITY;
      for (int by = -steepest; by <= steepest; ++by) {
        const auto before = static_cast<std::ptrdiff_t>(column) + by;
        if (before < 0 || before >= static_cast<std::ptrdiff_t>(columns)) continue;
        const double through = cost[static_cast<std::size_t>(before)] + bendCost * by * by;
        if (through >= best) continue;
        best = through;
        from[row * columns + column] = static_cast<std::uint8_t>(by + steepest);
      }
      next[column] = best + own;
    }
    cost.swap(next);
  }
  std::vector<std::size_t> path(band.rows);
  auto column = static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  for (std::size_t row = band.rows; row-- > 0;) {
    path[row] = column;
    column = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(column) + from[row * columns + column] -
                                      steepest);
  }
  return path;
}

// The middle of the line around an offset; the offset itself if there is none.
double centred(const Band& band, const std::vector<double>& coverage, std::size_t row, std::size_t column) {
  double sum = 0, moment = 0;
  const auto within = static_cast<std::size_t>(centreWithin_px / offsetStep_px);
  const std::size_t first = column > within ? column - within : 0,
                    last = std::min(column + within, band.columns - 1);
  for (std::size_t i = first; i <= last; ++i) {
    const double part = coverage[row * band.columns + i];
    if (part < clearCoverage) continue;
    sum += part;
    moment += part * band.offset_px(i);
  }
  return sum > 0 ? moment / sum : band.offset_px(column);
}

}  // namespace

std::vector<Point> followDrawn(const Raster& raster, const std::vector<Point>& drawn_px,
                               const DrawnOptions& options) {
  const std::vector<Point> drawn = withoutRepeatedPoints(drawn_px);
  if (drawn.size() < 2) return {};
  std::vector<Point> line = smoothLine(drawn, options.spacing_px);
  if (raster.empty()) return line;
  const Band band = bandAlong(raster, line, options.reach_px);
  const std::vector<double> coverage = coverageOf(band);
  const std::vector<std::size_t> path = bestPath(band, coverage);
  std::vector<Point> followed;
  followed.reserve(line.size());
  for (std::size_t row = 0; row < line.size(); ++row) {
    const Point n = normalAt(line, row);
    const double o = centred(band, coverage, row, path[row]);
    followed.push_back({line[row].x + o * n.x, line[row].y + o * n.y});
  }
  return followed;
}

}  // namespace detent::importer
