// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/frame/plot_rectangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

namespace detent::importer {
namespace {

constexpr double samePlace_px = 2.5;  // px; closer lines are one line
constexpr int maxPositions = 60;      // per direction and group; plots have fewer, drawings more
constexpr std::size_t maxRectanglesPerGroup = 10;
constexpr double minScore = 4;  // two drawn edges, and lines that end at the rectangle
constexpr double mostScore =
    1 + 4 * 1.5 + 0.08 * 16 + 3;       // corner, edges, grid, share inside; no line continues beyond
constexpr double minEdgeCover = 0.55;  // share of the edge's length

struct Group {
  std::vector<StraightLine> h, v;
};

/// Union-find over lines that touch, or nearly touch, at right angles.
class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// Axis lines of some programs stop short of the corner by a few per cent of their length.
bool touches(const StraightLine& h, const StraightLine& v) {
  const double reach = std::max(4.0, 0.05 * std::min(h.length(), v.length()));
  const double x = v.acrossAt(0.5 * (v.from + v.to)), y = h.acrossAt(std::clamp(x, h.from, h.to));
  return x >= h.from - reach && x <= h.to + reach && y >= v.from - reach && y <= v.to + reach;
}

std::vector<Group> groupsOf(const LineSet& lines) {
  const std::size_t nh = lines.horizontal.size(), nv = lines.vertical.size();
  Groups sets(nh + nv);
  for (std::size_t i = 0; i < nh; ++i)
    for (std::size_t j = 0; j < nv; ++j)
      if (touches(lines.horizontal[i], lines.vertical[j])) sets.unite(i, nh + j);
  std::vector<Group> groups(nh + nv);
  for (std::size_t i = 0; i < nh; ++i) groups[sets.root(i)].h.push_back(lines.horizontal[i]);
  for (std::size_t j = 0; j < nv; ++j) groups[sets.root(nh + j)].v.push_back(lines.vertical[j]);
  std::erase_if(groups, [](const Group& g) { return g.h.empty() || g.v.empty(); });
  return groups;
}

struct Position {
  double at = 0, weight = 0;
};

void addPosition(std::vector<Position>& positions, double at, double weight, double apart) {
  for (auto& p : positions) {
    if (std::abs(p.at - at) > apart) continue;
    p.at = (p.at * p.weight + at * weight) / (p.weight + weight);
    p.weight += weight;
    return;
  }
  positions.push_back({at, weight});
}

/// Candidate positions of edges: lines of one direction, and common ends of lines of the other.
std::vector<double> edgePositions(const std::vector<StraightLine>& along,
                                  const std::vector<StraightLine>& across) {
  std::vector<Position> lines, ends;
  for (const auto& line : along)
    addPosition(lines, line.acrossAt(0.5 * (line.from + line.to)), line.length(), 2.5);
  for (const auto& line : across) {
    addPosition(ends, line.from, line.length(), 3);
    addPosition(ends, line.to, line.length(), 3);
  }
  const auto heavier = [](const Position& a, const Position& b) { return a.weight > b.weight; };
  std::sort(lines.begin(), lines.end(), heavier);
  std::sort(ends.begin(), ends.end(), heavier);
  std::vector<double> out;
  // Long lines first, but always the outermost ones, because an edge is where the grid ends.
  if (lines.size() > static_cast<std::size_t>(maxPositions)) lines.resize(maxPositions);
  for (const auto& p : lines) out.push_back(p.at);
  int free = 0;
  for (const auto& p : ends) {
    const bool known =
        std::any_of(out.begin(), out.end(), [&](double at) { return std::abs(at - p.at) < 6; });
    if (!known && free < 6) {
      out.push_back(p.at);
      ++free;
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Positions of the next parallel lines beyond either edge; far away if there are none.
struct NextLines {
  double from = -1e9, to = 1e9;
};

struct EdgeFit {
  double overhang = 0;  ///< weighted sum of how far lines extend beyond the rectangle, in shares of it
  double inside = 0;    ///< length inside
  double length = 0;    ///< total length of the members
  int members = 0, endAtFrom = 0, endAtTo = 0;
  double reachFrom = 0, reachTo = 0;  ///< share of the gridlines that reach the edge
};

/// Cost of a line beyond the edge: small if it ends soon (ticks, open grids), large if it reaches the grid's
/// next line.
double overhangCost(double by, double size, bool edgeDrawn, double toNext) {
  const bool gridGoesOn = by >= toNext - 4;
  const double room = (edgeDrawn && !gridGoesOn ? 0.12 : 0.03) * size + 4;
  if (by <= room) return 0;
  return (edgeDrawn && !gridGoesOn ? 0.12 : 1.0) * std::min(1.0, by / (0.25 * size));
}

/// Fit of the lines of one direction: they end at the rectangle's edges or continue.
EdgeFit fitAlong(const std::vector<StraightLine>& lines, double from, double to, double acrossFrom,
                 double acrossTo, double coverFrom, double coverTo, const NextLines& next) {
  struct Place {
    double at = 0;
    bool from = false, to = false;
  };
  std::vector<Place> positions;
  positions.reserve(lines.size());
  EdgeFit fit;
  const double size = to - from, near = 0.015 * size + 3;
  for (const auto& line : lines) {
    const double inside = std::min(line.to, to) - std::max(line.from, from);
    if (inside < 0.12 * size) continue;
    const double at = line.acrossAt(std::clamp(0.5 * (from + to), line.from, line.to));
    if (at < acrossFrom - 4 || at > acrossTo + 4) continue;
    ++fit.members;
    fit.inside += inside;
    fit.length += line.length();
    // An axis may continue to an arrow; a gridline may not.
    const bool edge = at < acrossFrom + 4 || at > acrossTo - 4;
    const double weight = edge ? 0.15 : 1.0;
    fit.overhang += weight * overhangCost(from - line.from, size, coverFrom > 0.5, from - next.from);
    fit.overhang += weight * overhangCost(line.to - to, size, coverTo > 0.5, next.to - to);
    fit.endAtFrom += std::abs(line.from - from) <= near;
    fit.endAtTo += std::abs(line.to - to) <= near;
    auto place = std::find_if(positions.begin(), positions.end(),
                              [&](const Place& p) { return std::abs(p.at - at) < 4; });
    if (place == positions.end()) place = positions.insert(positions.end(), Place{at});
    place->from |= line.from <= from + near;
    place->to |= line.to >= to - near;
  }
  for (const auto& p : positions) {
    fit.reachFrom += p.from / static_cast<double>(positions.size());
    fit.reachTo += p.to / static_cast<double>(positions.size());
  }
  return fit;
}

/// Worth of an edge: a drawn edge that the grid reaches counts most; common line ends replace one that is not
/// drawn.
double edgeWorth(double drawn, double reach, int ends, int members) {
  const double open = members >= 3 ? 0.5 * ends / members : 0;
  // Titles over the plot hide the ends of many lines; a third is enough.
  return std::max(1.5 * drawn * (0.4 + 0.6 * std::min(1.0, 3 * reach)), open);
}

/// Drawn shares of edges at candidate positions, computed once per interval.
class CoverTable {
 public:
  CoverTable(const std::vector<StraightLine>& lines, const std::vector<double>& at,
             const std::vector<double>& ends)
      : n_(ends.size()), cover_(at.size() * n_ * n_, 0.0F) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto parts = mergedParts(lines, at[i]);
      if (parts.empty()) continue;
      for (std::size_t k = 0; k < n_; ++k)
        for (std::size_t l = k + 1; l < n_; ++l)
          cover_[(i * n_ + k) * n_ + l] = static_cast<float>(share(parts, ends[k], ends[l]));
    }
  }
  double operator()(std::size_t i, std::size_t k, std::size_t l) const {
    return static_cast<double>(cover_[(i * n_ + k) * n_ + l]);
  }

 private:
  using Parts = std::vector<std::pair<double, double>>;

  static Parts mergedParts(const std::vector<StraightLine>& lines, double at) {
    Parts parts, merged;
    for (const auto& line : lines)
      if (std::abs(line.acrossAt(0.5 * (line.from + line.to)) - at) <= samePlace_px)
        parts.emplace_back(line.from, line.to);
    std::sort(parts.begin(), parts.end());
    for (const auto& part : parts) {
      if (merged.empty() || part.first > merged.back().second)
        merged.push_back(part);
      else
        merged.back().second = std::max(merged.back().second, part.second);
    }
    return merged;
  }
  static double share(const Parts& parts, double from, double to) {
    double sum = 0;
    for (const auto& [a, b] : parts) sum += std::max(0.0, std::min(b, to) - std::max(a, from));
    return sum / (to - from);
  }

  std::size_t n_;
  std::vector<float> cover_;
};

/// Positions of lines that run through at least 60 % of the rectangle, without duplicates.
std::vector<double> spanningLines(const std::vector<StraightLine>& lines, double acrossFrom, double acrossTo,
                                  double from, double to) {
  std::vector<Position> positions;
  for (const auto& line : lines) {
    const double at = line.acrossAt(std::clamp(0.5 * (from + to), line.from, line.to));
    if (at < acrossFrom - 3 || at > acrossTo + 3) continue;
    addPosition(positions, at, line.length(), 2.5);
  }
  std::vector<double> placed, out;
  for (const auto& p : positions) placed.push_back(p.at);
  const CoverTable cover(lines, placed, {from, to});
  for (std::size_t i = 0; i < placed.size(); ++i)
    if (cover(i, 0, 1) >= 0.6) out.push_back(placed[i]);
  std::sort(out.begin(), out.end());
  return out;
}

/// The next line parallel to edge `i` in direction `step`, if close enough to belong to the same grid.
double nextLine(const CoverTable& cover, const std::vector<double>& at, std::size_t i, int step,
                std::size_t k, std::size_t l, double size) {
  for (auto m = static_cast<std::ptrdiff_t>(i) + step; m >= 0 && m < static_cast<std::ptrdiff_t>(at.size());
       m += step) {
    const double away = std::abs(at[static_cast<std::size_t>(m)] - at[i]);
    if (away > 0.45 * size) break;
    if (away > 0.03 * size + 4 && cover(static_cast<std::size_t>(m), k, l) > 0.15)
      return at[static_cast<std::size_t>(m)];
  }
  return step < 0 ? -1e9 : 1e9;
}

/// Returns true if more than a third of the vertical lines through a plot continue to the next line below it
/// (titles may hide some), or one continues by far. Stems of a few digits stand so close under their ticks
/// that these seem to continue to the digits' baseline.
bool goOnBelow(const std::vector<StraightLine>& upright, const Box& plot, double next) {
  std::ptrdiff_t members = 0, on = 0;
  for (const auto& line : upright) {
    const double at = line.acrossAt(std::clamp(plot.y1, line.from, line.to));
    if (at < plot.x0 - 4 || at > plot.x1 + 4 || line.from > plot.y1 - 0.12 * plot.height() ||
        line.to < plot.y1 - 4)
      continue;
    if (line.to - plot.y1 >= 2 * (next - plot.y1)) return true;
    ++members;
    on += line.to >= next - 4;
  }
  return 3 * on > members;
}

struct Candidates {
  std::vector<double> xs, ys;
  CoverTable columns, rows;
  explicit Candidates(const Group& g)
      : xs(edgePositions(g.v, g.h)), ys(edgePositions(g.h, g.v)), columns(g.v, xs, ys), rows(g.h, ys, xs) {}
};

/// The rectangle between four candidate positions; nullopt if no two adjacent edges are drawn, or too much of
/// its lines lies outside.
std::optional<PlotRectangle> scored(const Group& g, const Candidates& c, std::size_t i, std::size_t j,
                                    std::size_t k, std::size_t l) {
  PlotRectangle r;
  r.edgeCover = {c.columns(i, k, l), c.rows(k, i, j), c.columns(j, k, l), c.rows(l, i, j)};
  double corner = 0;
  for (std::size_t e = 0; e < 4; ++e)
    corner = std::max(corner, std::min(r.edgeCover[e], r.edgeCover[(e + 1) % 4]));
  if (corner < minEdgeCover) return std::nullopt;
  r.box = {c.xs[i], c.ys[k], c.xs[j], c.ys[l]};
  const Box& b = r.box;
  const NextLines across{nextLine(c.columns, c.xs, i, -1, k, l, b.width()),
                         nextLine(c.columns, c.xs, j, 1, k, l, b.width())};
  NextLines down{nextLine(c.rows, c.ys, k, -1, i, j, b.height()),
                 nextLine(c.rows, c.ys, l, 1, i, j, b.height())};
  const auto fitH = fitAlong(g.h, b.x0, b.x1, b.y0, b.y1, r.edgeCover[0], r.edgeCover[2], across);
  if (mostScore - 1.2 * fitH.overhang <= minScore) return std::nullopt;
  if (down.to < NextLines().to && !goOnBelow(g.v, b, down.to)) down.to = NextLines().to;
  const auto fitV = fitAlong(g.v, b.y0, b.y1, b.x0, b.x1, r.edgeCover[1], r.edgeCover[3], down);
  const double edges = edgeWorth(r.edgeCover[0], fitH.reachFrom, fitH.endAtFrom, fitH.members) +
                       edgeWorth(r.edgeCover[2], fitH.reachTo, fitH.endAtTo, fitH.members) +
                       edgeWorth(r.edgeCover[1], fitV.reachFrom, fitV.endAtFrom, fitV.members) +
                       edgeWorth(r.edgeCover[3], fitV.reachTo, fitV.endAtTo, fitV.members);
  const double grid = 0.08 * std::min(16, fitH.members + fitV.members);
  r.score = corner + edges + grid - 1.2 * (fitH.overhang + fitV.overhang) +
            3 * (fitH.inside + fitV.inside) / (fitH.length + fitV.length);
  return r;
}

double overlapOverUnion(const Box& a, const Box& b) {
  const Box common = a.common(b);
  return common.empty() ? 0 : common.area() / (a.area() + b.area() - common.area());
}

/// The best rectangles of one group, without variants of better ones.
std::vector<PlotRectangle> bestRectangles(const Group& g, double minWidth, double minHeight) {
  const Candidates c(g);
  std::vector<PlotRectangle> all;
  const auto consider = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    if (c.xs[j] - c.xs[i] < minWidth) return;
    if (auto r = scored(g, c, i, j, k, l); r && r->score > minScore) all.push_back(std::move(*r));
  };
  // Of two adjacent drawn edges one is vertical, so start from those.
  for (std::size_t i = 0; i < c.xs.size(); ++i)
    for (std::size_t k = 0; k < c.ys.size(); ++k)
      for (std::size_t l = k + 1; l < c.ys.size(); ++l) {
        if (c.ys[l] - c.ys[k] < minHeight || c.columns(i, k, l) < minEdgeCover) continue;
        for (std::size_t j = i + 1; j < c.xs.size(); ++j) consider(i, j, k, l);
        for (std::size_t j = 0; j < i; ++j)
          if (c.columns(j, k, l) < minEdgeCover) consider(j, i, k, l);
      }
  std::sort(all.begin(), all.end(),
            [](const PlotRectangle& a, const PlotRectangle& b) { return a.score > b.score; });
  std::vector<PlotRectangle> kept;
  for (auto& r : all) {
    if (kept.size() >= maxRectanglesPerGroup) break;
    const bool variant = std::any_of(kept.begin(), kept.end(), [&](const PlotRectangle& k) {
      return overlapOverUnion(k.box, r.box) > 0.5;
    });
    if (!variant) kept.push_back(std::move(r));
  }
  for (auto& r : kept) {
    r.xLines = spanningLines(g.v, r.box.x0, r.box.x1, r.box.y0, r.box.y1);
    r.yLines = spanningLines(g.h, r.box.y0, r.box.y1, r.box.x0, r.box.x1);
  }
  return kept;
}

}  // namespace

std::vector<PlotRectangle> findPlotRectangles(const LineSet& lines, double minWidth_px, double minHeight_px) {
  std::vector<PlotRectangle> found;
  for (const auto& group : groupsOf(lines)) {
    auto best = bestRectangles(group, minWidth_px, minHeight_px);
    found.insert(found.end(), std::make_move_iterator(best.begin()), std::make_move_iterator(best.end()));
  }
  return found;
}

}  // namespace detent::importer
