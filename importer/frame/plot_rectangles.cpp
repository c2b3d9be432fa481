#include "importer/frame/plot_rectangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace detent::importer {
namespace {

constexpr int maxPositions =
    14;  // per direction and group; a page border with drawings has more, a plot has not
constexpr int maxRectanglesPerGroup = 6;
constexpr double minEdgeCover = 0.55;

struct Group {
  std::vector<StraightLine> h, v;
};

/// Union-find over lines that touch or nearly touch at right angles.
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
  const double reachH = std::max(4.0, 0.05 * h.length()), reachV = std::max(4.0, 0.05 * v.length());
  const double x = v.acrossAt(0.5 * (v.from + v.to)), y = h.acrossAt(std::clamp(x, h.from, h.to));
  return x >= h.from - reachH && x <= h.to + reachH && y >= v.from - reachV && y <= v.to + reachV;
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

/// Where edges could stand: at lines of the one direction and at common ends of lines of the other.
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
  // Long lines first; the outermost ones always, for an edge is where the grid ends.
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

/// Share of [from, to] that lines near `at` cover.
double coverage(const std::vector<StraightLine>& lines, double at, double apart, double from, double to) {
  std::vector<std::pair<double, double>> parts;
  const double mid = 0.5 * (from + to);
  for (const auto& line : lines)
    if (std::abs(line.acrossAt(std::clamp(mid, line.from, line.to)) - at) <= apart && line.to > from &&
        line.from < to)
      parts.emplace_back(std::max(line.from, from), std::min(line.to, to));
  std::sort(parts.begin(), parts.end());
  double sum = 0, end = from;
  for (const auto& [a, b] : parts) {
    if (b <= end) continue;
    sum += b - std::max(a, end);
    end = b;
  }
  return sum / (to - from);
}

struct EdgeFit {
  double overhang = 0;  // how far members stick out, in shares of the rectangle, summed
  double inside = 0;    // length inside
  int members = 0, endAtFrom = 0, endAtTo = 0;
};

/// How the lines of one direction sit in the rectangle: do they end at its edges, or run on?
EdgeFit fitAlong(const std::vector<StraightLine>& lines, double from, double to, double acrossFrom,
                 double acrossTo) {
  EdgeFit fit;
  const double size = to - from, tick = 0.03 * size + 4, near = 0.015 * size + 3;
  for (const auto& line : lines) {
    const double at = line.acrossAt(std::clamp(0.5 * (from + to), line.from, line.to));
    if (at < acrossFrom - 4 || at > acrossTo + 4) continue;
    const double inside = std::min(line.to, to) - std::max(line.from, from);
    if (inside < 0.12 * size) continue;
    ++fit.members;
    fit.inside += inside;
    if (line.from < from - tick) fit.overhang += std::min(1.0, (from - line.from) / (0.25 * size));
    if (line.to > to + tick) fit.overhang += std::min(1.0, (line.to - to) / (0.25 * size));
    fit.endAtFrom += std::abs(line.from - from) <= near;
    fit.endAtTo += std::abs(line.to - to) <= near;
  }
  return fit;
}

double totalLength(const Group& g) {
  double sum = 0;
  for (const auto& line : g.h) sum += line.length();
  for (const auto& line : g.v) sum += line.length();
  return sum;
}

/// Lines that run through at least 60 % of the rectangle, each position once.
std::vector<double> spanningLines(const std::vector<StraightLine>& lines, double acrossFrom, double acrossTo,
                                  double from, double to) {
  std::vector<Position> positions;
  for (const auto& line : lines) {
    const double at = line.acrossAt(std::clamp(0.5 * (from + to), line.from, line.to));
    if (at < acrossFrom - 3 || at > acrossTo + 3) continue;
    addPosition(positions, at, line.length(), 2.5);
  }
  std::vector<double> out;
  for (const auto& p : positions)
    if (coverage(lines, p.at, 2.5, from, to) >= 0.6) out.push_back(p.at);
  std::sort(out.begin(), out.end());
  return out;
}

/// Ends that agree stand for an edge that is not drawn (grids open at the top).
double openEdge(double drawn, int ends, int members) {
  return members >= 3 ? std::max(drawn, 0.8 * ends / members) : drawn;
}

bool scoreRectangle(const Group& g, double groupLength, PlotRectangle& r) {
  const auto& b = r.box;
  const double apart = 2.5;
  r.edgeCover = {coverage(g.v, b.x0, apart, b.y0, b.y1), coverage(g.h, b.y0, apart, b.x0, b.x1),
                 coverage(g.v, b.x1, apart, b.y0, b.y1), coverage(g.h, b.y1, apart, b.x0, b.x1)};
  double corner = 0;
  for (std::size_t k = 0; k < 4; ++k)
    corner = std::max(corner, std::min(r.edgeCover[k], r.edgeCover[(k + 1) % 4]));
  if (corner < minEdgeCover) return false;
  const auto fitH = fitAlong(g.h, b.x0, b.x1, b.y0, b.y1), fitV = fitAlong(g.v, b.y0, b.y1, b.x0, b.x1);
  r.xLines = spanningLines(g.v, b.x0, b.x1, b.y0, b.y1);
  r.yLines = spanningLines(g.h, b.y0, b.y1, b.x0, b.x1);
  const double edges = openEdge(r.edgeCover[0], fitH.endAtFrom, fitH.members) +
                       openEdge(r.edgeCover[2], fitH.endAtTo, fitH.members) +
                       openEdge(r.edgeCover[1], fitV.endAtFrom, fitV.members) +
                       openEdge(r.edgeCover[3], fitV.endAtTo, fitV.members);
  const double grid = 0.15 * std::min<double>(8, static_cast<double>(r.xLines.size() + r.yLines.size()));
  r.score = 2 * corner + edges + grid - 1.2 * (fitH.overhang + fitV.overhang) +
            4 * (fitH.inside + fitV.inside) / groupLength;
  return true;
}

std::optional<PlotRectangle> bestRectangle(const Group& g, double minWidth, double minHeight) {
  const auto xs = edgePositions(g.v, g.h), ys = edgePositions(g.h, g.v);
  const double length = totalLength(g);
  std::optional<PlotRectangle> best;
  for (std::size_t i = 0; i < xs.size(); ++i)
    for (std::size_t j = i + 1; j < xs.size(); ++j) {
      if (xs[j] - xs[i] < minWidth) continue;
      for (std::size_t k = 0; k < ys.size(); ++k)
        for (std::size_t l = k + 1; l < ys.size(); ++l) {
          if (ys[l] - ys[k] < minHeight) continue;
          PlotRectangle r;
          r.box = {xs[i], ys[k], xs[j], ys[l]};
          if (scoreRectangle(g, length, r) && (!best || r.score > best->score)) best = std::move(r);
        }
    }
  return best;
}

/// What belongs to a found rectangle goes, so that its neighbours in the same group can be found.
void removeMembers(std::vector<StraightLine>& lines, double from, double to, double acrossFrom,
                   double acrossTo) {
  std::erase_if(lines, [&](const StraightLine& line) {
    const double at = line.acrossAt(0.5 * (line.from + line.to));
    const double inside = std::min(line.to, to) - std::max(line.from, from);
    return at >= acrossFrom - 4 && at <= acrossTo + 4 && inside > 0.5 * line.length();
  });
}

}  // namespace

std::vector<PlotRectangle> findPlotRectangles(const LineSet& lines, double minWidth_px, double minHeight_px) {
  std::vector<PlotRectangle> found;
  for (auto& group : groupsOf(lines)) {
    for (int n = 0; n < maxRectanglesPerGroup; ++n) {
      auto best = bestRectangle(group, minWidth_px, minHeight_px);
      if (!best) break;
      removeMembers(group.h, best->box.x0, best->box.x1, best->box.y0, best->box.y1);
      removeMembers(group.v, best->box.y0, best->box.y1, best->box.x0, best->box.x1);
      found.push_back(std::move(*best));
    }
  }
  return found;
}

}  // namespace detent::importer
