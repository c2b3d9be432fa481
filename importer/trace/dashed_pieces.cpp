// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/dashed_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "importer/page/polyline.h"
#include "importer/page/quantile.h"
#include "importer/trace/scatter.h"

namespace detent::importer {
namespace {

constexpr std::size_t fewestDashPieces = 8,
                      mostDashPieces = 2000;  // pieces of a line; pieces of one colour that are not noise
constexpr double leastGap = 0.35;             // widths; letters and pieces of a solid line are closer
constexpr double longestDashGap = 8;          // widths
constexpr double onwards = 0.15;              // cosine between a piece's direction and the next gap
constexpr double shortestOfGaps = 0.4, longestOfGaps = 1.7;  // of the line's usual gap; a bend shortens them
// share of the gaps, and their deviation from the usual one
constexpr double evenShare = 0.8, evenWithin = 0.35;
constexpr double sameWidth = 1.6;                   // times
constexpr double leastTurnedBack = 0.3;             // share of a piece's length, from its end
constexpr double dotLength = 1.6, dashLength = 12;  // of a dot, in roots of its area; of a dash, in widths

/// A piece and the end at which it is reached: 0 its first point, 1 its last.
struct Met {
  std::size_t piece = 0, end = 0;
};

class DashSearch {
 public:
  explicit DashSearch(const std::vector<DashPiece>& pieces) : pieces_(pieces), taken_(pieces.size(), 0) {}

  std::vector<DashedLine> all() {
    std::vector<DashedLine> lines;
    for (std::size_t seed = 0; seed < pieces_.size(); ++seed)
      if (!taken_[seed])
        if (auto line = lineThrough(seed)) lines.push_back(std::move(*line));
    return lines;
  }

 private:
  bool isDot(std::size_t piece) const { return pieces_[piece].points.size() < 2; }
  Point endOf(Met met) const {
    const auto& points = pieces_[met.piece].points;
    return met.end == 0 ? points.front() : points.back();
  }
  /// Direction out of a piece at one end; its last bit alone may be a corner of its outline. 0 for a dot.
  Point outOf(Met met) const {
    const auto& points = pieces_[met.piece].points;
    const double least_px = leastTurnedBack * lengthOf(points);
    const Point end = endOf(met);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point p = met.end == 0 ? points[i] : points[points.size() - 1 - i];
      if (distance(p, end) >= least_px && distance(p, end) > 0) return 1 / distance(p, end) * (end - p);
    }
    return {};
  }

  /// Returns the nearest dash end ahead; ends in line are preferred. The gap of a dot begins at its rim.
  std::optional<Met> nextOf(Met from, Point ahead, double usual_px, double& gap_px) const {
    const double width_px = pieces_[from.piece].width_px;
    std::optional<Met> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const double times = pieces_[k].width_px / width_px;
      if (taken_[k] || k == from.piece || times > sameWidth || times < 1 / sameWidth) continue;
      for (const std::size_t end : {0U, 1U}) {
        if (end == 1 && isDot(k)) continue;
        const Point way = endOf({k, end}) - endOf(from);
        const double between_px = norm(way);
        const double rims_px = 0.5 * ((isDot(k) ? 1 : 0) + (isDot(from.piece) ? 1 : 0)) * width_px;
        const double free_px = between_px - rims_px;
        if (free_px < leastGap * width_px || free_px > longestDashGap * width_px) continue;
        if (usual_px > 0 && (free_px < shortestOfGaps * usual_px || free_px > longestOfGaps * usual_px))
          continue;
        const double straight = norm(ahead) > 0 ? dot(ahead, way) / (norm(ahead) * between_px) : 1;
        const double into = isDot(k) ? 1 : -dot(outOf({k, end}), way) / between_px;
        if (straight < onwards || into < onwards) continue;
        if (const double cost = between_px * (3 - straight - into); cost < least)
          least = cost, best = Met{k, end}, gap_px = free_px;
      }
    }
    return best;
  }

  /// Members in the order of the line, from the seed in direction `ahead`.
  std::vector<Met> follow(Met from, Point ahead, std::vector<double>& gaps) {
    std::vector<Met> met;
    double gap_px = 0;
    while (const auto next = nextOf(from, ahead, medianOf(gaps), gap_px)) {
      const Point before = endOf(from);
      gaps.push_back(gap_px);
      taken_[next->piece] = 1;
      met.push_back(*next);
      from = {next->piece, 1 - next->end};
      ahead = isDot(next->piece) ? endOf(from) - before : outOf(from);
    }
    return met;
  }

  std::optional<DashedLine> lineThrough(std::size_t seed) {
    taken_[seed] = 1;
    std::vector<double> gaps;
    std::vector<Met> forth = follow({seed, 1}, outOf({seed, 1}), gaps);
    std::vector<Met> back;
    if (!isDot(seed)) back = follow({seed, 0}, outOf({seed, 0}), gaps);
    if (isDot(seed) && !forth.empty())
      back = follow({seed, 0}, endOf({seed, 0}) - endOf(forth.front()), gaps);
    if (forth.size() + back.size() + 1 < fewestDashPieces || !even(gaps)) {
      taken_[seed] = 0;
      for (const auto* way : {&forth, &back})
        for (const Met& each : *way) taken_[each.piece] = 0;
      return {};
    }
    DashedLine line;
    std::vector<double> widths;
    const auto add = [&](std::size_t piece, bool forwards) {
      std::vector<Point> points = pieces_[piece].points;
      if (!forwards) std::reverse(points.begin(), points.end());
      line.points.insert(line.points.end(), points.begin(), points.end());
      line.members.push_back(piece);
      widths.push_back(pieces_[piece].width_px);
    };
    for (std::size_t i = back.size(); i-- > 0;) add(back[i].piece, back[i].end == 1);
    add(seed, true);
    for (const Met& each : forth) add(each.piece, each.end == 0);
    line.width_px = medianOf(widths);
    return line;
  }

  static bool even(const std::vector<double>& gaps) {
    const double usual_px = medianOf(gaps);
    const auto regular = std::ranges::count_if(
        gaps, [&](double gap_px) { return std::abs(gap_px - usual_px) <= evenWithin * usual_px; });
    return static_cast<double>(regular) >= evenShare * static_cast<double>(gaps.size());
  }

  const std::vector<DashPiece>& pieces_;
  std::vector<char> taken_;
};

/// A bent dash: its ends are the two similar edges of its outline that are farthest apart. nullopt for a dot.
std::optional<DashPiece> bentDash(const Polyline& ring, Point middle) {
  constexpr double alike = 1.05, leastApart = 1.5;  // ratios; closer edges are the sides of a dot
  constexpr std::size_t mostEdges = 200;            // edges are compared in pairs
  if (ring.size() > mostEdges) return {};
  struct Edge {
    Point middle;
    double length_px;
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    edges.push_back({0.5 * (a + b), distance(a, b)});
  }
  std::optional<DashPiece> best;
  double most_px = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const auto [shorter, longer] = std::minmax(edges[i].length_px, edges[k].length_px);
      const double apart_px = distance(edges[i].middle, edges[k].middle);
      if (longer > alike * shorter || apart_px < leastApart * longer || apart_px + longer <= most_px)
        continue;
      most_px = apart_px + longer;  // edges along the sides are shorter than those across
      best = DashPiece{{edges[i].middle, middle, edges[k].middle}, longer};
    }
  return best;
}

}  // namespace

std::optional<DashPiece> dashOfOutline(const std::vector<Point>& outline, double largest_px) {
  Polyline ring = withoutRepeats(outline);
  while (ring.size() > 1 && distance(ring.front(), ring.back()) < 1e-9) ring.pop_back();
  if (ring.size() < 4) return {};
  const Scatter scatter(ring);
  const Point middle = scatter.middle(), along = scatter.along();
  double first = 0, last = 0, low = 0, high = 0;
  for (const Point& p : ring) {
    const double t = dot(p - middle, along), u = cross(along, p - middle);
    first = std::min(first, t), last = std::max(last, t), low = std::min(low, u), high = std::max(high, u);
  }
  const double length_px = last - first;
  if (!(length_px > 0) || length_px > largest_px) return {};
  const double area_px = 0.5 * std::abs(twiceAreaOf(ring)), side_px = std::sqrt(area_px);
  const double width_px = std::min(high - low, area_px / length_px);
  if (!(width_px > 0) || length_px > dashLength * width_px) return {};
  // A dot has no direction: its piece is the centre of its box.
  if (length_px < dotLength * side_px)
    return DashPiece{{middle + 0.5 * (first + last) * along + 0.5 * (low + high) * Point{-along.y, along.x}},
                     side_px};
  if (auto bent = bentDash(ring, middle)) return bent;
  return DashPiece{{middle + first * along, middle + last * along}, width_px};
}

std::vector<DashedLine> dashedLines(const std::vector<DashPiece>& pieces) {
  if (pieces.size() < fewestDashPieces || pieces.size() > mostDashPieces) return {};
  return DashSearch(pieces).all();
}

}  // namespace detent::importer
