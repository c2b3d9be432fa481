// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/follow_drawn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>

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
constexpr double wayCost = 0.15;         // of a pixel of the curve; one of paper costs 1 more

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

/// The smooth line through the drawn points from one of them to the next, without the last point.
std::vector<Point> smoothPiece(const std::vector<Point>& drawn, std::size_t i) {
  const Point before = i > 0 ? drawn[i - 1] : mix(drawn[1], drawn[0], 2);
  const Point after = i + 2 < drawn.size() ? drawn[i + 2] : mix(drawn[i], drawn[i + 1], 2);
  const int pieces = std::max(1, static_cast<int>(std::ceil(distance(drawn[i], drawn[i + 1]))));
  std::vector<Point> line;
  for (int k = 0; k < pieces; ++k)
    line.push_back(onSpline({before, drawn[i], drawn[i + 1], after}, static_cast<double>(k) / pieces));
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

/// The colour that a curve is drawn in, and the paper around it.
struct Pen {
  Color3 paper, color;
  /// 1 the curve, 0 the paper; other colours count by their similarity.
  double coverage(Color3 c) const {
    return std::clamp(1 - distance(c, color) / distance(paper, color), 0.0, 1.0);
  }
};

/// The places within reach of a point, and how near they are: 1 the point, 0 the end of the reach.
template <class Visit>
void visitAround(Point p, double reach_px, const Visit& visit) {
  for (double dy = -reach_px; dy <= reach_px; dy += 1)
    for (double dx = -reach_px; dx <= reach_px; dx += 1)
      if (const double d = std::hypot(dx, dy); d <= reach_px)
        visit(Point{p.x + dx, p.y + dy}, 1 - d / reach_px);
}

/// A place on the curve beside a drawn point. `score`: 1 on the very point, 0 if there is none.
struct PlaceOnCurve {
  Point at;
  double score = 0;
};

/// The place within reach of a drawn point that is most of the curve and near; the point itself on paper.
PlaceOnCurve onCurve(const Raster& raster, const Pen& pen, Point drawn, double reach_px) {
  PlaceOnCurve best{drawn};
  visitAround(drawn, reach_px, [&](Point at, double near) {
    const double score = (0.5 + 0.5 * near) * pen.coverage(colorBetween(raster, at));
    if (score > std::max(best.score, clearCoverage)) best = {at, score};
  });
  return best;
}

/// The pen that drew the curve beside the drawn points. Each point offers the colour near it that differs
/// most from the paper; of these the one that stands nearest to all points together. Where two curves run
/// side by side most points may offer the other one's. nullopt on bare paper.
std::optional<Pen> penBeside(const Raster& raster, const std::vector<Point>& drawn, double reach_px) {
  std::vector<Color3> all;
  for (const Point& p : drawn)
    visitAround(p, reach_px, [&](Point at, double) { all.push_back(colorBetween(raster, at)); });
  const Color3 paper = medianOf(std::move(all));
  std::optional<Pen> pen;
  std::vector<Color3> compared;
  double most = 0;
  for (const Point& p : drawn) {
    Color3 strongest = paper;
    double contrast = leastMarkContrast;
    visitAround(p, reach_px, [&](Point at, double near) {
      const Color3 color = colorBetween(raster, at);
      if (const double d = (0.5 + 0.5 * near) * distance(color, paper); d > contrast)
        contrast = d, strongest = color;
    });
    const auto isNear = [&](Color3 other) { return distance(strongest, other) < leastMarkContrast; };
    if (isNear(paper) || std::ranges::any_of(compared, isNear)) continue;
    compared.push_back(strongest);
    const Pen offered{paper, strongest};
    double sum = 0;
    for (const Point& each : drawn) sum += onCurve(raster, offered, each, reach_px).score;
    if (sum > most) most = sum, pen = offered;
  }
  return pen;
}

/// The way between two places with the most of the curve for its length, pixel by pixel, without its end.
/// Empty if it runs over paper for the most part. A place outside the picture counts as the nearest in it.
std::vector<Point> wayOnCurve(const Raster& raster, const Pen& pen, Point from, Point to, double reach_px) {
  constexpr double aside = 0.5;  // distances of the two places; a curve between them stays within
  const double margin_px = 2 * reach_px + aside * distance(from, to);
  const auto cut = [](double at_px, int size_px) {
    return static_cast<int>(std::clamp(std::lround(at_px), 0L, size_px - 1L));
  };
  const auto [left, right] = std::minmax(from.x, to.x);
  const auto [top, lowest] = std::minmax(from.y, to.y);
  const int x0 = cut(left - margin_px, raster.width_px), x1 = cut(right + margin_px, raster.width_px),
            y0 = cut(top - margin_px, raster.height_px), y1 = cut(lowest + margin_px, raster.height_px);
  const int width = x1 - x0 + 1, height = y1 - y0 + 1;
  const auto placeOf = [&](Point p) {
    return (cut(p.y, raster.height_px) - y0) * width + cut(p.x, raster.width_px) - x0;
  };
  struct Node {
    double cost;
    int place;
    bool operator>(const Node& other) const { return cost > other.cost; }
  };
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<double> costs(size, INFINITY);
  std::vector<int> cameFrom(size, -1);
  std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
  const int start = placeOf(from), goal = placeOf(to);
  costs[static_cast<std::size_t>(start)] = 0;
  open.push({0, start});
  while (!open.empty()) {
    const Node node = open.top();
    open.pop();
    if (node.place == goal) break;
    if (node.cost > costs[static_cast<std::size_t>(node.place)]) continue;
    const int x = node.place % width, y = node.place / width;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height) continue;
        const int next = node.place + dy * width + dx;
        const double paper = 1 - pen.coverage(colorAt(raster, x0 + x + dx, y0 + y + dy));
        const double cost = node.cost + std::hypot(dx, dy) * (wayCost + paper);
        if (cost >= costs[static_cast<std::size_t>(next)]) continue;
        costs[static_cast<std::size_t>(next)] = cost;
        cameFrom[static_cast<std::size_t>(next)] = node.place;
        open.push({cost, next});
      }
  }
  std::vector<Point> way;
  double covered = 0;
  for (int at = cameFrom[static_cast<std::size_t>(goal)]; at >= 0;
       at = cameFrom[static_cast<std::size_t>(at)]) {
    const int x = x0 + at % width, y = y0 + at / width;
    way.push_back({static_cast<double>(x), static_cast<double>(y)});
    covered += pen.coverage(colorAt(raster, x, y));
  }
  if (covered < clearCoverage * static_cast<double>(way.size())) return {};
  std::ranges::reverse(way);
  return way;
}

/// Without the steps of pixels: each point the mean of its neighbours.
std::vector<Point> withoutSteps(const std::vector<Point>& line) {
  constexpr std::size_t most = 3;  // neighbours on either side
  std::vector<Point> smooth = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t beside = std::min({most, i, line.size() - 1 - i});
    Point sum;
    for (std::size_t k = i - beside; k <= i + beside; ++k) sum = sum + line[k];
    smooth[i] = (1.0 / static_cast<double>(2 * beside + 1)) * sum;
  }
  return smooth;
}

/// The drawn line on the curve's pixels, piece by piece.
std::vector<Point> lineOnCurve(const Raster& raster, const Pen& pen, const std::vector<Point>& drawn,
                               double reach_px) {
  std::vector<Point> line, snapped;
  for (const Point& p : drawn) snapped.push_back(onCurve(raster, pen, p, reach_px).at);
  for (std::size_t i = 0; i + 1 < drawn.size(); ++i) {
    std::vector<Point> way = wayOnCurve(raster, pen, snapped[i], snapped[i + 1], reach_px);
    if (way.empty()) way = smoothPiece(drawn, i);
    line.insert(line.end(), way.begin(), way.end());
  }
  line.push_back(snapped.back());
  return withoutSteps(line);
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

std::vector<Point> followDrawn(const Raster& raster, const std::vector<Point>& drawn_px, double reach_px) {
  const std::vector<Point> drawn = withoutRepeatedPoints(drawn_px);
  if (drawn.size() < 2) return {};
  const std::optional<Pen> pen = raster.empty() ? std::nullopt : penBeside(raster, drawn, reach_px);
  if (!pen) {
    std::vector<Point> line;
    for (std::size_t i = 0; i + 1 < drawn.size(); ++i) {
      const std::vector<Point> piece = smoothPiece(drawn, i);
      line.insert(line.end(), piece.begin(), piece.end());
    }
    line.push_back(drawn.back());
    return line;
  }
  const std::vector<Point> line = lineOnCurve(raster, *pen, drawn, reach_px);
  const Band band = bandAlong(raster, line, reach_px);
  std::vector<double> coverage;
  for (const Color3& color : band.colors) coverage.push_back(pen->coverage(color));
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
