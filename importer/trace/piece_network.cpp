// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/piece_network.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <unordered_map>

namespace detent::importer {
namespace {

// Costs. Unit: a quarter of the price of one uncovered plot width.
constexpr double uncovered = 4;     // per plot width at either end
constexpr double rightAngle = 0.4;  // of a join that turns by 90°
constexpr double anyJoin = 0.005;   // of any join
constexpr double sharpestTurn_deg = 130;
constexpr double repeated =
    3.8;  // per plot width shared with an earlier stroke; less than leaving it uncovered
constexpr double levelTravel =
    4;  // per plot width along one horizontal line, which may be a gridline and so gains nothing
constexpr double axisParallelPiece = 0.1;     // of a piece that runs along an axis
constexpr double gridPiece = 0.8;             // of one that also lies on a gridline
constexpr double smallPiece = 0.005;          // of a piece as small as a letter
constexpr double gapPerDiagonal = 2.5;        // per length of a gap, in the plot's diagonals
constexpr double stopsWhereLineGoesOn = 0.3;  // of an end at which a join would have been cheap
constexpr double widthDoubling = 0.05;        // of a join of lines of which one is twice as wide
constexpr double surelyGoesOn = 0.24;         // cost of a join below which the line continues

constexpr double longestNetworkGap = 0.03;  // share of the diagonal
constexpr double longestBreak = 0.08;       // share of the diagonal, between two lines
constexpr double timesTheBreak = 2;         // each line is at least this many times as long
constexpr double nearlyTouching = 0.004;    // share of the diagonal; closer ends have no direction of the gap
constexpr double directionStretch = 0.004;  // share of the diagonal
constexpr double facing_deg = 50;           // turned into the gap and out of it, together
constexpr double mostOwn = 0.15;            // share of the width, not shared with earlier ones

double angleBetween_deg(Point a, Point b) {
  return std::abs(std::atan2(cross(a, b), dot(a, b))) * 180 / std::numbers::pi;
}

/// Returns true if the end tangents face each other across the gap; `ahead`, `back`: directions out of the
/// lines.
bool face(Point here, Point ahead, Point there, Point back) {
  const Point away = there - here;
  return angleBetween_deg(ahead, away) + angleBetween_deg(back, -1.0 * away) <= facing_deg;
}

/// Direction out of a line's first or last point over a short stretch, because the last segment may be as
/// short as a rounding error.
Point directionOut(const std::vector<Point>& line, bool atEnd, double stretch) {
  const std::size_t n = line.size();
  const Point end = atEnd ? line.back() : line.front();
  for (std::size_t i = 1; i < n; ++i) {
    const Point p = atEnd ? line[n - 1 - i] : line[i];
    if (distance(p, end) >= stretch || i + 1 == n) return end - p;
  }
  return {1, 0};
}

/// Ends of pieces by place, so that thousands of letter strokes are cheap.
class EndGrid {
 public:
  explicit EndGrid(double cell) : cell_(cell) {}
  void add(Point p, std::size_t id) { cells_[keyOf(p, 0, 0)].push_back(id); }
  template <class Visit>
  void around(Point p, Visit visit) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const auto found = cells_.find(keyOf(p, dx, dy));
        if (found == cells_.end() || found->second.size() > crowd) continue;
        for (const std::size_t id : found->second) visit(id);
      }
  }

 private:
  std::uint64_t keyOf(Point p, int dx, int dy) const {
    const auto x = static_cast<std::int64_t>(std::floor(p.x / cell_)) + dx;
    const auto y = static_cast<std::int64_t>(std::floor(p.y / cell_)) + dy;
    return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xffffffffu);
  }
  static constexpr std::size_t crowd = 200;  // ends in one place; more are letters or hatching
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

struct Touch {
  std::size_t segment = 0;
  double along = 0;  ///< 0..1 on the segment
  Point baselinePoint;
};

/// Nearest inner point of the line; nullopt if an end is nearer.
std::optional<Touch> touchInside(const std::vector<Point>& line, Point p, double reach) {
  if (distance(line.front(), p) <= reach || distance(line.back(), p) <= reach) return std::nullopt;
  std::optional<Touch> best;
  double bestDistance = reach;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point a = line[i - 1], b = line[i];
    const double t = projectionOn(a, b, p);
    const Point lowest = a + t * (b - a);
    const double d = distance(lowest, p);
    if (d <= bestDistance) {
      bestDistance = d;
      best = Touch{i - 1, t, lowest};
    }
  }
  return best;
}

/// Cuts the line at its touches, which are sorted here.
std::vector<std::vector<Point>> cutAt(const std::vector<Point>& line, std::vector<Touch> touches) {
  std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) {
    return a.segment != b.segment ? a.segment < b.segment : a.along < b.along;
  });
  std::vector<std::vector<Point>> parts{{line.front()}};
  std::size_t next = 0;
  for (std::size_t segment = 0; segment + 1 < line.size(); ++segment) {
    for (; next < touches.size() && touches[next].segment == segment; ++next) {
      const Point lowest = touches[next].baselinePoint;
      if (distance(parts.back().back(), lowest) > 1e-9) parts.back().push_back(lowest);
      if (parts.back().size() > 1) parts.push_back({lowest});
    }
    if (distance(parts.back().back(), line[segment + 1]) > 1e-9) parts.back().push_back(line[segment + 1]);
  }
  if (parts.back().size() < 2) parts.pop_back();
  return parts;
}

}  // namespace

PieceNetwork::PieceNetwork(std::vector<LinePiece> pieces, const PlotPlane& plane)
    : pieces_(std::move(pieces)), plane_(plane) {
  cutAtTouches();
  links_.resize(2 * pieces_.size());
  used_.resize(pieces_.size(), 0);
  for (const LinePiece& piece : pieces_)
    spans_.push_back(plane_.across(piece.points.back()) - plane_.across(piece.points.front()));
  linkTouchingEnds();
  bridgeGaps();
}

double PieceNetwork::touchDistance(const LinePiece& a, const LinePiece& b) const {
  return std::min(0.006 * plane_.diagonal(),
                  0.001 * plane_.diagonal() + 0.5 * std::max(a.width_px, b.width_px));
}

void PieceNetwork::cutAtTouches() {
  // Only lines that could be a curve are cut, and only by ends that could belong to one: a release that runs
  // into the press, a bottom-out that stands on it. Grid and letters do not count.
  std::vector<std::vector<Touch>> touches(pieces_.size());
  std::vector<std::size_t> cutters;
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (!pieces_[i].onGridLine) cutters.push_back(i);
  for (std::size_t target = 0; target < pieces_.size(); ++target) {
    const LinePiece& line = pieces_[target];
    const bool isVertical = line.axisParallel && !line.onGridLine &&
                            std::abs(line.points.back().x - line.points.front().x) <= line.width_px;
    if ((line.axisParallel && !isVertical) || line.small) continue;
    const double reach = 0.006 * plane_.diagonal();
    const Box extent = boundsOf(line.points).grown(reach, reach);
    for (const std::size_t cutter : cutters) {
      if (cutter == target || (isVertical ? pieces_[cutter].axisParallel : pieces_[cutter].small)) continue;
      for (const Point& end : {pieces_[cutter].points.front(), pieces_[cutter].points.back()}) {
        if (!extent.contains(end)) continue;
        if (const auto touch = touchInside(line.points, end, touchDistance(line, pieces_[cutter])))
          touches[target].push_back(*touch);
      }
    }
  }
  std::vector<LinePiece> cut;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (touches[i].empty()) {
      cut.push_back(std::move(pieces_[i]));
      continue;
    }
    for (auto& part : cutAt(pieces_[i].points, touches[i])) {
      LinePiece piece = pieces_[i];
      piece.points = std::move(part);
      cut.push_back(std::move(piece));
    }
  }
  pieces_ = std::move(cut);
}

Point PieceNetwork::endOf(std::size_t piece, bool atEnd) const {
  return atEnd ? pieces_[piece].points.back() : pieces_[piece].points.front();
}

Point PieceNetwork::outwardDirection(std::size_t piece, bool atEnd) const {
  return directionOut(pieces_[piece].points, atEnd, directionStretch * plane_.diagonal());
}

void PieceNetwork::linkTouchingEnds() {
  EndGrid grid(std::max(0.006 * plane_.diagonal(), 1e-6));
  for (std::size_t id = 0; id < links_.size(); ++id) grid.add(endOf(id / 2, id % 2 == 1), id);
  for (std::size_t id = 0; id < links_.size(); ++id) {
    const Point here = endOf(id / 2, id % 2 == 1);
    grid.around(here, [&](std::size_t other) {
      if (other / 2 == id / 2) return;
      const double gap = distance(here, endOf(other / 2, other % 2 == 1));
      if (gap <= touchDistance(pieces_[id / 2], pieces_[other / 2]))
        links_[id].push_back({other / 2, other % 2 == 1, gap / plane_.diagonal()});
    });
  }
}

bool PieceNetwork::isLoose(std::size_t id) const {
  if (pieces_[id / 2].onGridLine) return false;
  return std::all_of(links_[id].begin(), links_[id].end(), [&](const Link& link) {
    return pieces_[link.piece].small || pieces_[link.piece].axisParallel;
  });
}

template <class MayMeet>
void PieceNetwork::bridgeLooseEnds(double reach, MayMeet mayMeet) {
  const double reach_px = reach * plane_.diagonal();
  EndGrid grid(std::max(reach_px, 1e-6));
  std::vector<std::size_t> free;
  for (std::size_t id = 0; id < links_.size(); ++id)
    if (isLoose(id)) free.push_back(id);
  for (const std::size_t id : free) grid.add(endOf(id / 2, id % 2 == 1), id);
  for (const std::size_t id : free) {
    const Point here = endOf(id / 2, id % 2 == 1), direction = outwardDirection(id / 2, id % 2 == 1);
    grid.around(here, [&](std::size_t other) {
      if (other / 2 == id / 2) return;
      const Point there = endOf(other / 2, other % 2 == 1);
      const double gap_px = distance(here, there);
      if (gap_px > reach_px || !mayMeet(id / 2, other / 2, gap_px)) return;
      const bool facing = face(here, direction, there, outwardDirection(other / 2, other % 2 == 1));
      if (!facing && gap_px > nearlyTouching * plane_.diagonal()) return;
      links_[id].push_back({other / 2, other % 2 == 1, gap_px / plane_.diagonal()});
    });
  }
}

void PieceNetwork::bridgeGaps() {
  // Dashes drawn one by one, and lines that stop before a text.
  bridgeLooseEnds(longestNetworkGap, [](std::size_t, std::size_t, double) { return true; });
  // Dashed lines: both parts are much longer than the gap.
  const auto isLong = [&](std::size_t piece, double gap_px) {
    return !pieces_[piece].small && !pieces_[piece].axisParallel &&
           lengthOf(pieces_[piece].points) >= timesTheBreak * gap_px;
  };
  bridgeLooseEnds(longestBreak, [&](std::size_t one, std::size_t other, double gap_px) {
    return isLong(one, gap_px) && isLong(other, gap_px);
  });
}

double PieceNetwork::joinCost(std::size_t from, bool fromEnd, const Link& link) const {
  const Point out = outwardDirection(from, fromEnd), next = outwardDirection(link.piece, link.atEnd);
  const double turn = angleBetween_deg(out, -1.0 * next);
  if (turn > sharpestTurn_deg) return std::numeric_limits<double>::infinity();
  const double widths = std::abs(std::log2(pieces_[from].width_px / pieces_[link.piece].width_px));
  return anyJoin + rightAngle * (turn / 90) * (turn / 90) + gapPerDiagonal * link.gap +
         widthDoubling * widths;
}

double PieceNetwork::pathCost(std::size_t piece, bool forward) const {
  const LinePiece& line = pieces_[piece];
  const double gain = forward ? spans_[piece] : -spans_[piece];
  double cost = line.onGridLine ? gridPiece : line.axisParallel ? axisParallelPiece : 0;
  if (line.axisParallel) cost += levelTravel * std::abs(gain);
  if (line.small) cost += smallPiece;
  return cost + repeated * used_[piece] * std::abs(gain);
}

bool PieceNetwork::visiblyGoesOn(std::size_t from, bool fromEnd, const Link& link) const {
  constexpr double levelSpan = 0.02;  // share of the plot's width
  constexpr double touching = 0.01;   // share of the diagonal
  constexpr double sameWidth =
      0.7;  // in powers of two; a thin vertical line on a thick curve is a continuation mark
  const LinePiece &here = pieces_[from], &next = pieces_[link.piece];
  if (next.onGridLine || link.gap > touching) return false;
  if (!next.axisParallel) return joinCost(from, fromEnd, link) <= surelyGoesOn;
  const bool level = std::abs(spans_[link.piece]) > levelSpan;  // more likely a gridline
  if (level || std::abs(std::log2(here.width_px / next.width_px)) > sameWidth) return false;
  return joinCost(from, fromEnd, link) <= (isBottomOutUp(link) ? rightAngle * 1.1 : surelyGoesOn);
}

bool PieceNetwork::isBottomOutUp(const Link& link) const {
  constexpr double leastHeight = 0.1;  // of the plot's
  constexpr int mostParts = 8;         // strokes that end on the vertical line have cut it
  double rise = 0;
  Link part = link;
  for (int i = 0; i < mostParts; ++i) {
    rise += endOf(part.piece, part.atEnd).y - endOf(part.piece, !part.atEnd).y;
    const auto& onward = linksOf(part.piece, !part.atEnd);
    const auto next = std::find_if(onward.begin(), onward.end(), [&](const Link& l) {
      return pieces_[l.piece].axisParallel && !pieces_[l.piece].onGridLine &&
             joinCost(part.piece, !part.atEnd, l) < surelyGoesOn;
    });
    if (next == onward.end()) break;
    part = *next;
  }
  return rise > leastHeight * plane_.box.height();
}

double PieceNetwork::endCost(const Step& step, bool atEnd) const {
  const bool side = atEnd ? step.forward : !step.forward;
  const double at = plane_.across(endOf(step.piece, side));
  const double cost = uncovered * std::max(0.0, atEnd ? 1 - at : at);
  for (const Link& link : linksOf(step.piece, side))
    if (visiblyGoesOn(step.piece, side, link) && (atEnd || used_[link.piece] == 0))
      return cost + stopsWhereLineGoesOn;
  return cost;
}

FoundStroke PieceNetwork::strokeAlong(const std::vector<Step>& steps, double cost) const {
  FoundStroke stroke;
  stroke.ownLength = 0;
  double longest = 0;
  for (const Step& step : steps) {
    std::vector<Point> points = pieces_[step.piece].points;
    if (!step.forward) std::reverse(points.begin(), points.end());
    for (const Point& p : points)
      if (stroke.points.empty() || distance(stroke.points.back(), p) > 1e-6) stroke.points.push_back(p);
    if (!pieces_[step.piece].axisParallel) stroke.slanted += std::abs(spans_[step.piece]);
    const double span = std::abs(spans_[step.piece]);
    (used_[step.piece] == 0 ? stroke.ownLength : stroke.sharedLength) += span;
    if (const double length = lengthOf(points); length > longest) {
      longest = length;
      stroke.width_px = pieces_[step.piece].width_px;
    }
  }
  stroke.from = plane_.across(stroke.points.front());
  stroke.to = plane_.across(stroke.points.back());
  stroke.joinCost =
      std::max(0.0, cost - repeated * stroke.sharedLength -
                        uncovered * (std::max(0.0, stroke.from) + std::max(0.0, 1 - stroke.to)));
  return stroke;
}

std::optional<FoundStroke> PieceNetwork::nextStroke(double leastCover) {
  // Dijkstra over (piece, direction); the state's cost includes traversing the piece.
  const std::size_t states = links_.size();
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<double> cost(states, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(states, none);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto stepOf = [](std::size_t state) { return Step{state / 2, state % 2 == 0}; };
  for (std::size_t state = 0; state < states; ++state) {
    const Step step = stepOf(state);
    if (pieces_[step.piece].axisParallel || used_[step.piece] > 0) continue;
    cost[state] = endCost(step, false) + pathCost(step.piece, step.forward);
    queue.push({cost[state], state});
  }
  std::size_t best = none;
  double bestCost = std::numeric_limits<double>::infinity();
  while (!queue.empty()) {
    const auto [reached, state] = queue.top();
    queue.pop();
    if (reached > cost[state] || reached >= bestCost) continue;
    const Step step = stepOf(state);
    if (const double whole = reached + endCost(step, true); whole < bestCost) {
      bestCost = whole;
      best = state;
    }
    for (const Link& link : linksOf(step.piece, step.forward)) {
      const std::size_t next = 2 * link.piece + (link.atEnd ? 1 : 0);
      const double through =
          reached + joinCost(step.piece, step.forward, link) + pathCost(link.piece, !link.atEnd);
      if (through < cost[next]) {
        cost[next] = through;
        before[next] = state;
        queue.push({through, next});
      }
    }
  }
  if (best == none) return std::nullopt;
  std::vector<Step> steps;
  for (std::size_t state = best; state != none; state = before[state]) steps.push_back(stepOf(state));
  std::reverse(steps.begin(), steps.end());
  extend(steps, false);
  extend(steps, true);
  FoundStroke stroke = strokeAlong(steps, bestCost);
  const double leastOwn = std::min(mostOwn, 0.5 * leastCover);
  if (stroke.to - stroke.from < leastCover || stroke.ownLength < leastOwn || stroke.slanted < leastOwn)
    return std::nullopt;
  for (const Step& step : steps) ++used_[step.piece];
  return stroke;
}

void PieceNetwork::extend(std::vector<Step>& steps, bool atEnd) const {
  // Vertical lines at both ends add no travel, so the search did not take them; they are added here.
  const auto walked = [&](std::size_t piece) {
    return std::any_of(steps.begin(), steps.end(), [&](const Step& s) { return s.piece == piece; });
  };
  while (true) {
    const Step& last = atEnd ? steps.back() : steps.front();
    const bool side = atEnd ? last.forward : !last.forward;
    const Link* best = nullptr;
    double bestCost = std::numeric_limits<double>::infinity();
    for (const Link& link : linksOf(last.piece, side)) {
      const bool taken =
          !atEnd && used_[link.piece] > 0;  // strokes may share their bottom-out, not their beginning
      if (!visiblyGoesOn(last.piece, side, link) || pieces_[link.piece].small || taken || walked(link.piece))
        continue;
      if (const double cost = joinCost(last.piece, side, link); cost < bestCost)
        bestCost = cost, best = &link;
    }
    if (!best) return;
    if (atEnd) {
      steps.push_back({best->piece, !best->atEnd});
    } else {
      steps.insert(steps.begin(), {best->piece, best->atEnd});
    }
  }
}

std::vector<UnusedLine> PieceNetwork::unusedLines() const {
  // Some documents draw a curve twice; a copy is not another curve.
  constexpr double straightChord = 0.9995;  // share of the length; leaders are straight
  EndGrid taken(std::max(0.006 * plane_.diagonal(), 1e-6));
  std::vector<Point> positions;
  const double step = 0.004 * plane_.diagonal();
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (used_[i] > 0)
      for (const Point& p : densified(pieces_[i].points, step)) {
        taken.add(p, positions.size());
        positions.push_back(p);
      }
  std::vector<UnusedLine> unused;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const LinePiece& piece = pieces_[i];
    if (used_[i] > 0 || piece.axisParallel || piece.small) continue;
    const double length = lengthOf(piece.points);
    const std::vector<Point> along = densified(piece.points, step);
    const auto fresh = std::ranges::count_if(along, [&](Point p) {
      bool near = false;
      taken.around(p, [&](std::size_t id) { near = near || distance(positions[id], p) < step; });
      return !near;
    });
    UnusedLine line{piece.points, 0, false};
    if (spans_[i] < 0) std::reverse(line.points.begin(), line.points.end());
    line.fresh = length / plane_.diagonal() * static_cast<double>(fresh) / static_cast<double>(along.size());
    line.straight = piece.points.size() < 3 ||
                    distance(piece.points.front(), piece.points.back()) > straightChord * length;
    unused.push_back(std::move(line));
  }
  return unused;
}

bool PieceNetwork::isRestOf(const FoundStroke& stroke, const UnusedLine& line) const {
  constexpr double leastRest = 0.04;         // share of the plot's width
  constexpr double leastFresh = 0.5;         // share of its length; less is a copy
  constexpr std::size_t measuredPoints = 8;  // a leader has two or three
  if (line.fresh * plane_.diagonal() < leastFresh * lengthOf(line.points)) return false;
  const double from = plane_.across(line.points.front()), to = plane_.across(line.points.back());
  const bool after = to - std::max(from, stroke.to) >= leastRest;
  const bool before = std::min(to, stroke.from) - from >= leastRest;
  if (!after && !before) return false;
  if (!line.straight || line.points.size() >= measuredPoints) return true;
  const double stretch = directionStretch * plane_.diagonal();
  const auto end = [&](const std::vector<Point>& points, bool atEnd) {
    return std::pair(atEnd ? points.back() : points.front(), directionOut(points, atEnd, stretch));
  };
  const auto [strokeEnd, ahead] = end(stroke.points, after);
  const auto [lineEnd, back] = end(line.points, !after);
  return face(strokeEnd, ahead, lineEnd, back);
}

}  // namespace detent::importer
