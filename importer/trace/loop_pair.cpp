// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/loop_pair.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "importer/page/polyline.h"

namespace detent::importer::trace {

namespace {

/// Pixels that a path may use: near remaining pixels, and a little farther along explained lines.
Plane openPixels(const Structure& s, const WorkPlane& plane) {
  constexpr float kNear = 15, kAlongLine = 40;  // px, to the nearest curve pixel
  constexpr double kOutside = 2;                // px
  Plane open(s.remainingCoverage.width, s.remainingCoverage.height);
  for (int y = 0; y < open.height; ++y) {
    if (y < plane.frame.y0 - kOutside || y > plane.frame.y1 + kOutside) continue;
    for (int x = 0; x < open.width; ++x) {
      if (x < plane.frame.x0 - kOutside || x > plane.frame.x1 + kOutside) continue;
      const bool line = s.isOnLine(x, y);
      open.at(x, y) = s.gapDistance.at(x, y) <= (line ? kAlongLine : kNear) ? 1.0F : 0.0F;
    }
  }
  return open;
}

void forDisc(const Plane& grid, Point centre, double radius, const auto& visit) {
  const int x0 = static_cast<int>(std::ceil(centre.x - radius)),
            x1 = static_cast<int>(std::floor(centre.x + radius));
  const int y0 = static_cast<int>(std::ceil(centre.y - radius)),
            y1 = static_cast<int>(std::floor(centre.y + radius));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double dx = x - centre.x, dy = y - centre.y;
      if (grid.inside(x, y) && dx * dx + dy * dy <= radius * radius) visit(x, y);
    }
  }
}

/// The reward left for the other stroke; pixels of the first are worth `shared` each.
Plane rewardBeside(const Plane& reward, const std::vector<Point>& taken, double radius, float shared = 0) {
  Plane left = reward;
  for (const Point& p : taken) {
    forDisc(left, p, radius, [&](int x, int y) { left.at(x, y) = std::min(left.at(x, y), shared); });
  }
  return left;
}

double strongPixels(const Plane& reward) {
  return static_cast<double>(
      std::count_if(reward.values.begin(), reward.values.end(), [](float r) { return r > 0.5F; }));
}

/// Length of curve pixels on `path` that `other` does not cover.
double ownCoverage(const std::vector<Point>& path, const Plane& left) {
  double own = 0;
  for (const Point& p : path) {
    const float r = left.at(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
    if (r > 0.3F) own += r;
  }
  return own;
}

struct Stretch {
  std::size_t from = 0, to = 0;
  double length = 0;
};

/// Share of curve pixels or explained pixels on the straight line between two points.
double coverageBetween(const Plane& reward, Point a, Point b) {
  const int n = std::max(1, static_cast<int>(std::ceil(distance(a, b))));
  int inked = 0;
  for (int i = 0; i <= n && i - inked <= 3; ++i) {
    const Point p = a + (static_cast<double>(i) / n) * (b - a);
    float best = -1;
    forDisc(reward, p, 1.5, [&](int x, int y) { best = std::max(best, reward.at(x, y)); });
    if (best > 0) ++inked;
  }
  return double(inked) / (n + 1);
}

/// The longest detour of a path: it leaves a line and returns to it close by. Leaders, marker lines and latch
/// branches of alternate-action switches make detours; a curve does not, because it is not closed below a
/// peak.
std::optional<Stretch> findDetour(const std::vector<Point>& path, const Plane& reward, double strokeWidth,
                                  const Box& frame) {
  const double widest = 0.06 * frame.width();
  if (static_cast<double>(path.size()) > 6 * (frame.width() + frame.height()))
    return std::nullopt;  // no curve at all
  const double shortest = std::max(10 * strokeWidth, 0.12 * frame.height());
  // Down one edge of an arrow's head that touches the curve and up the other.
  const double shortestAtHead = std::max(8 * strokeWidth, 0.05 * frame.height()),
               widestHead = 0.03 * frame.width();
  const std::vector<double> arc = arcOf(path);
  std::optional<Stretch> longest;
  constexpr std::size_t kStep = 3;
  for (std::size_t i = 0; i < path.size(); i += kStep) {
    for (std::size_t j = i + kStep; j < path.size() && path[j].x - path[i].x <= widest; j += kStep) {
      const double length = arc[j] - arc[i];
      if (length < shortestAtHead || (longest && length <= longest->length)) continue;
      const double chord = distance(path[j], path[i]);
      if (chord > widest || length < 4 * chord) continue;
      if (length < shortest && (chord > widestHead || chord <= strokeWidth + 1.5)) continue;
      if (chord > strokeWidth + 1.5 && coverageBetween(reward, path[i], path[j]) < 0.9) continue;
      longest = Stretch{i, j, length};
    }
  }
  return longest;
}

/// Cuts a detour at either end of a path, a steep end followed up and down, at its turning point. Returns
/// false if it is none.
bool cutAtTurn(std::vector<Point>& path, const Stretch& detour, double frameWidth) {
  const double nearEnd = 0.05 * frameWidth;
  const bool atBack = path.back().x - path[detour.to].x < nearEnd;
  const bool atFront = path[detour.from].x - path.front().x < nearEnd;
  if (!atBack && !atFront) return false;
  const Point base = path[atBack ? detour.from : detour.to];
  std::size_t tip = detour.from;
  double farthest = 0;
  for (std::size_t k = detour.from; k <= detour.to; ++k) {
    const double d = distance(path[k], base);
    if (d <= farthest) continue;
    farthest = d;
    tip = k;
  }
  const std::size_t before = path.size();
  if (atBack) {
    path.resize(tip + 1);
  } else {
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(tip));
  }
  return path.size() < before;
}

/// The best path without a detour. Pixels of found detours are removed from `reward` for later searches too.
std::vector<Point> directPath(LiftedSearch& search, Plane& reward, const std::vector<Point>& taken,
                              double radius, const PathLimits& limits, double strokeWidth, float shared,
                              const Box& frame) {
  constexpr int kDetours = 6;
  constexpr float kNoCurve = -0.4F;  // reward per pixel, below that of paper near the curve
  std::vector<Point> path;
  for (int i = 0; i <= kDetours; ++i) {
    path = densified(search.best(rewardBeside(reward, taken, radius, shared), limits).points, 1);
    std::optional<Stretch> detour = findDetour(path, reward, strokeWidth, frame);
    while (detour && cutAtTurn(path, *detour, frame.width()))
      detour = findDetour(path, reward, strokeWidth, frame);
    if (!detour || i == kDetours) break;
    // The base of the detour is curve; only what stands off it is removed.
    const Point start = path[detour->from], end = path[detour->to];
    for (std::size_t k = detour->from; k < detour->to; ++k) {
      const Point p = path[k];
      if (distance(p, start + projectionOn(start, end, p) * (end - start)) < 1.5 * strokeWidth + 2) continue;
      forDisc(reward, p, strokeWidth / 2 + 1,
              [&](int x, int y) { reward.at(x, y) = std::min(reward.at(x, y), kNoCurve); });
    }
  }
  return path;
}

/// Twice the signed area between a piece of each path; positive if the first lies to the left of travel.
double leftness(const std::vector<Point>& a, std::size_t a0, std::size_t a1, const std::vector<Point>& b,
                std::size_t b0, std::size_t b1) {
  Polyline ring(a.begin() + static_cast<std::ptrdiff_t>(a0), a.begin() + static_cast<std::ptrdiff_t>(a1) + 1);
  for (std::size_t j = b1 + 1; j-- > b0;) ring.push_back(b[j]);
  return twiceAreaOf(ring);
}

/// Gives the shorter stroke the rest of the longer one if it ends on it. Not on the force axis, where each
/// stroke starts at its own force.
void shareEnd(std::vector<Point>& shorter, const std::vector<Point>& longer, double within,
              double axisColumn) {
  const Point end = shorter.back();
  std::size_t at = longer.size();
  double best = within * within;
  for (std::size_t j = 0; j < longer.size(); ++j) {
    const Point off = longer[j] - end;
    if (dot(off, off) > best) continue;
    best = dot(off, off);
    at = j;
  }
  const auto rest = longer.begin() + static_cast<std::ptrdiff_t>(std::min(at + 1, longer.size()));
  const bool onAxis =
      std::all_of(rest, longer.end(), [&](Point p) { return std::abs(p.x - axisColumn) <= 0.6 * within; });
  if (!onAxis) shorter.insert(shorter.end(), rest, longer.end());
}

/// At the bottom-out a hole (text) may separate the strokes' ends, so more is bridged there than at the
/// start, where strokes may begin apart.
void shareEnds(std::vector<Point>& a, std::vector<Point>& b, double strokeWidth, const Box& frame) {
  const double noAxis = frame.x1 + frame.width();
  const double atBottomOut = 2.5 * strokeWidth + 2, atStart = strokeWidth + 1;
  shareEnd(a, b, atBottomOut, noAxis);
  shareEnd(b, a, atBottomOut, noAxis);
  std::reverse(a.begin(), a.end());
  std::reverse(b.begin(), b.end());
  shareEnd(a, b, atStart, frame.x0);
  shareEnd(b, a, atStart, frame.x0);
  std::reverse(a.begin(), a.end());
  std::reverse(b.begin(), b.end());
}

/// Pixels on the force axis up to where the release leaves it belong to the release; the press starts at its
/// own force.
void startOnAxis(std::vector<Point>& press, std::vector<Point>& release, double axisColumn, double within) {
  const auto leaves = [&](std::vector<Point>& p) {
    return std::find_if(p.begin(), p.end(), [&](Point q) { return std::abs(q.x - axisColumn) > within; });
  };
  const auto pressLeaves = leaves(press), releaseLeaves = leaves(release);
  if (pressLeaves - press.begin() < 3 || pressLeaves == press.end() || releaseLeaves == release.end()) return;
  const double releaseRow = releaseLeaves->y;
  if (press.front().y <= releaseRow) return;
  const auto above = std::find_if(press.begin(), pressLeaves, [&](Point q) { return q.y <= releaseRow; });
  if (press.front().y > release.front().y + 1) {
    std::vector<Point> whole(press.begin(), above);
    whole.insert(whole.end(), releaseLeaves, release.end());
    release = std::move(whole);
  }
  press.erase(press.begin(), above);
}

/// Lengths of dashes that continue from `end` along the unit vector `ahead`; crossing lines of the plot hide
/// both dashes and gaps. The first dash shows the direction better than a short tail.
std::vector<double> dashesBeyond(Point end, Point ahead, const Structure& s, double strokeWidth) {
  constexpr double kFirstSpread = 0.06, kSpread = 0.03;  // share of the way, on either side
  constexpr int kLeastGap = 2;
  std::vector<double> dashes;
  std::vector<Point> dash;
  double gap = 0, longest = 20 * strokeWidth;
  for (double t = 1; gap <= 2 * longest; t += 1) {
    const Point p = end + t * ahead, across{-ahead.y, ahead.x};
    if (!s.remainingCoverage.inside(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))))
      break;
    const double reach = 1 + (dashes.empty() ? kFirstSpread : kSpread) * t;
    std::optional<Point> inked;
    bool hidden = false;
    for (double off = -reach; off <= reach; off += 1) {
      const Point q = p + off * across;
      const int x = static_cast<int>(std::lround(q.x)), y = static_cast<int>(std::lround(q.y));
      if (!s.remainingCoverage.inside(x, y)) continue;
      if (s.remainingCoverage.at(x, y) > 0.5F) inked = q;
      hidden = hidden || s.isOnLine(x, y);
    }
    if (hidden && !inked) continue;
    const bool ownEnd = dashes.empty() && dash.empty() && gap < kLeastGap;
    if (inked && ownEnd && t > 2 * strokeWidth + 2) return {};  // the stroke continues
    if (inked) {
      if (!ownEnd) dash.push_back(*inked);
      gap = 0;
      continue;
    }
    gap += 1;
    if (dash.empty() || gap < kLeastGap) continue;
    const double length = distance(dash.front(), dash.back()) + 1;
    const Point middle = dash[dash.size() / 2];
    if (dashes.empty()) ahead = (1 / distance(middle, end)) * (middle - end);
    longest = dashes.empty() ? length : std::max(longest, length);
    dashes.push_back(length);
    dash.clear();
  }
  return dashes;
}

/// Returns true off all marks, including the plot's straight lines: farther than `off_px` from the nearest
/// curve pixel.
bool isPaper(Point p, const Structure& s, float off_px) {
  const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
  return s.gapDistance.inside(x, y) && s.gapDistance.at(x, y) > off_px && !s.isOnLine(x, y);
}

/// Points of a path from which on it crosses paper: gaps of two pixels and more, in order.
std::vector<std::size_t> gapsAlong(const std::vector<Point>& path, const Structure& s) {
  constexpr std::size_t kLeastGap = 2;
  constexpr float kOff_px = 1;  // from the nearest curve pixel
  std::vector<std::size_t> gaps;
  std::size_t bare = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    bare = isPaper(path[i], s, kOff_px) ? bare + 1 : 0;
    if (bare == kLeastGap) gaps.push_back(i + 1 - kLeastGap);
  }
  return gaps;
}

/// Number of points of a path before the first dash of a bottom-out that continues in dashes from `solid` on;
/// that dash is attached to the solid line: the length of a dash, as far as it is straight. Letters and
/// leaders make no row of dashes in line with a bottom-out. nullopt without such dashes.
std::optional<std::size_t> pointsBeforeDashes(const std::vector<Point>& path, std::size_t solid,
                                              const Structure& s, double strokeWidth) {
  constexpr std::size_t kLeastDashes = 2;
  constexpr double kAlike = 3;  // times the shortest
  const auto tail = static_cast<std::size_t>(8 * strokeWidth + 6);
  if (solid < 3 * tail) return {};
  const Point end = path[solid - 1], before = path[solid - 1 - tail];
  const double run = distance(end, before);
  if (!(run > 0) || before.y - end.y < 0.9 * run) return {};  // not steep
  const Point ahead = (1 / run) * (end - before);
  const std::vector<double> dashes = dashesBeyond(end, ahead, s, strokeWidth);
  if (dashes.size() < kLeastDashes) return {};
  const auto [shortest, longest] = std::minmax_element(dashes.begin(), dashes.end());
  if (*shortest < 2 * strokeWidth || *longest > kAlike * *shortest) return {};
  std::size_t kept = solid;
  while (kept > tail && distance(path[kept - 1], end) < *longest &&
         std::abs(cross(path[kept - 1] - end, ahead)) <= strokeWidth + 1)
    --kept;
  return kept;
}

/// Cuts a path where its bottom-out continues in dashes, over which it may have been led; before the first
/// gap that is followed by a row of them. Returns true if there are such dashes.
bool cutDashedEnd(std::vector<Point>& path, const Structure& s, double strokeWidth, const Box& frame) {
  constexpr double kLast = 0.1;  // share of the frame's width: the part that may be the bottom-out
  constexpr std::size_t kGapsBefore =
      2;  // more of them: the whole stroke is dashed, and so is its bottom-out
  std::vector<std::size_t> ends = gapsAlong(path, s);
  const auto last = std::ranges::find_if(
      ends, [&](std::size_t at) { return path[at].x > path.back().x - kLast * frame.width(); });
  if (last - ends.begin() > static_cast<std::ptrdiff_t>(kGapsBefore)) return false;
  ends.erase(ends.begin(), last);
  ends.push_back(path.size());
  for (const std::size_t solid : ends)
    if (const auto kept = pointsBeforeDashes(path, solid, s, strokeWidth)) {
      path.resize(*kept);
      return true;
    }
  return false;
}

/// Indices of two points at which two lines touch.
struct TouchingPoints {
  std::size_t a, b;
};

std::vector<TouchingPoints> touchingPoints(const std::vector<Point>& a, const std::vector<Point>& b,
                                           double within) {
  std::vector<TouchingPoints> touches;
  std::size_t from = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double best = within * within;
    std::size_t at = b.size();
    for (std::size_t j = from; j < b.size() && b[j].x <= a[i].x + within; ++j) {
      const Point off = a[i] - b[j];
      if (dot(off, off) < best) {
        best = dot(off, off);
        at = j;
      }
    }
    if (at == b.size()) continue;
    touches.push_back({i, at});
    from = at;
  }
  return touches;
}

// share of the frame's width: remaining pixels that may be a curve or a bottom-out
constexpr double kMuch = 0.2;
/// Of the frame's height below the strokes' tops: bottom-outs of other switches have at least 0.23, leaders
/// at most 0.15.
constexpr double kBottomOutBelow = 0.2;
// share of the frame's height: the last part of a bottom-out, and how much lower than the strokes it may end
constexpr double kBottomOutTop = 0.1;
constexpr double kBottomOutRise = 1.8;  // times its width over that part; leaders lean more, 1.5
constexpr double kJump = 0.05;          // share of the frame's height; holes of words are narrower
// share of the width: a lock from the start; remaining pixels beside both
constexpr double kLocked = 0.15, kLeftBeside = 0.1;
constexpr double kEquallyLow = 0.06;  // share of the height: equally low, meeting
constexpr float kOffCurve_px = 1.5F;  // from the nearest curve pixel
constexpr double kPiece = 0.04;  // share of the width: a piece of a curve between two crossings; less is text

/// A joint search for both strokes at one price of gaps.
class PairSearch {
 public:
  PairSearch(const Structure& structure, const WorkPlane& plane, const GapPrice& price, float shared)
      : structure_(structure),
        plane_(plane),
        stroke_(structure.strokeWidth_px),
        shared_(shared),
        reward_(rewardOf(structure, plane, price)),
        search_(openPixels(structure, plane), PathOptions{}) {}

  /// Returns false if nothing could be a curve.
  bool run() {
    const int lastColumn = reward_.width - 1;
    const PathLimits anywhere{0, lastColumn, 0, lastColumn};
    a_ = follow({}, anywhere);
    // A filled area gives a path that sweeps it; no force curve is that long.
    const double longest = 4 * (plane_.frame.width() + plane_.frame.height());
    if (a_.size() < 2 || static_cast<double>(a_.size()) > longest) return false;
    b_ = follow(a_, anywhere);
    if ((locked_ = endsLocked())) return true;
    const std::vector<Point> third = pieceLeftOut(anywhere);
    for (int round = 0; round < 2; ++round) {
      const PathLimits ends = endsFrom(third);
      const std::vector<Point> before = a_;
      if (b_.size() > 1) {
        std::vector<Point> again = follow(b_, ends);
        if (again.size() > 1) a_ = std::move(again);
      }
      const bool bReaches = b_.size() > 1 && b_.front().x <= ends.startTo && b_.back().x >= ends.endFrom;
      if (a_ == before && bReaches) break;
      b_ = follow(a_, ends);
    }
    return true;
  }

  /// Length of pixels explained by both strokes.
  double explained_px() const { return ownCoverage(a_, reward_) + ownOfSecond(); }

  /// Length of curve-like pixels beside both, as if they were one line.
  double leftOver_px() const {
    return strongPixels(rewardBeside(reward_, bothStrokes(), stroke_ + 1)) / std::max(1.0, stroke_);
  }

  /// Unbroken pieces of the best path through the remaining pixels, except crossings and gaps of dashes. It
  /// may cross both strokes, but not follow them or their rims.
  std::vector<std::vector<Point>> furtherPieces() {
    if (leftOver_px() < kMuch * plane_.frame.width()) return {};
    const int lastColumn = reward_.width - 1;
    const double beside = stroke_ + 1, hole_px = 2 * stroke_ + 2;
    const std::vector<Point> way = directPath(search_, reward_, bothStrokes(), beside,
                                              {0, lastColumn, 0, lastColumn}, stroke_, 0, plane_.frame);
    const Plane own = rewardBeside(reward_, bothStrokes(), beside);
    std::vector<std::vector<Point>> pieces(1);
    double since = 0;
    for (const Point& p : way) {
      if (own.at(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))) <= 0.3F) {
        since += 1;
        continue;
      }
      if (since > hole_px) pieces.emplace_back();
      pieces.back().push_back(p);
      since = 0;
    }
    std::erase_if(pieces, [&](const std::vector<Point>& piece) {
      return static_cast<double>(piece.size()) < kPiece * plane_.frame.width();
    });
    return pieces;
  }

  /// Returns true if such a piece climbs steeply to about the tops of both strokes from far below; a piece
  /// that begins at their tops continues them.
  bool isBottomOut(const std::vector<Point>& piece) const {
    const std::vector<Point> strokes = bothStrokes();
    const double top = std::ranges::min_element(strokes, {}, &Point::y)->y, height = plane_.frame.height();
    const auto [highest, lowest] = std::ranges::minmax(piece, {}, &Point::y);
    if (lowest.y - top < kBottomOutBelow * height || highest.y > top + kBottomOutTop * height) return false;
    const double lastFrom = highest.y + kBottomOutTop * height;
    const auto isLast = [&](Point p) { return p.y <= lastFrom; };
    const auto from = std::ranges::find_if(piece, isLast), to = std::ranges::find(piece, highest);
    return from <= to && from->y - highest.y >= kBottomOutRise * (highest.x - from->x);
  }

  /// Returns true if a stroke crosses paper where the line it came on continues unexplained: it changed to
  /// another line.
  bool changesLine() const {
    const Plane left = rewardBeside(reward_, bothStrokes(), stroke_ + 1);
    const double jump_px = kJump * plane_.frame.height(), around_px = 2 * kPiece * plane_.frame.width();
    const double least_px2 = kPiece * plane_.frame.width() * stroke_;
    const auto goesOn = [&](Point from) {
      int covered_px2 = 0;
      forDisc(left, from, around_px, [&](int x, int y) { covered_px2 += left.at(x, y) > 0.5F ? 1 : 0; });
      return covered_px2 >= least_px2;
    };
    const auto jumps = [&](const std::vector<Point>& stroke) {
      double run_px = 0;
      Point from{};
      for (std::size_t i = 1; i < stroke.size(); ++i) {
        if (run_px == 0) from = stroke[i - 1];
        run_px =
            isPaper(stroke[i], structure_, kOffCurve_px) ? run_px + distance(stroke[i], stroke[i - 1]) : 0;
        if (run_px >= jump_px && goesOn(from)) return true;
      }
      return false;
    };
    return jumps(a_) || jumps(b_);
  }

  /// Returns true if the second stroke's own stretch is broken often and evenly, unlike a path over leaders
  /// and words.
  bool secondIsDashed() const {
    const Plane own = rewardBeside(reward_, a_, stroke_ + 1);
    std::vector<int> gaps;
    int run = 0;
    for (const Point& p : b_) {
      const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
      if (reward_.at(x, y) < 0) {
        ++run;
        continue;
      }
      if (run > 0 && own.at(x, y) > 0.3F) gaps.push_back(run);
      run = 0;
    }
    if (gaps.size() < 8) return false;
    std::sort(gaps.begin(), gaps.end());
    const int usual = gaps[gaps.size() / 2], large = gaps[gaps.size() * 9 / 10];
    return large <= 3 * usual + 2;
  }

  PlanePair parted() {
    PlanePair pair;
    pair.bottomOutsCut = cutDashedEnd(a_, structure_, stroke_, plane_.frame);
    pair.bottomOutsCut = cutDashedEnd(b_, structure_, stroke_, plane_.frame) || pair.bottomOutsCut;
    pair.ownRelease_px = ownOfSecond();
    pair.locked = locked_;
    if (pair.ownRelease_px < 0.05 * plane_.frame.width()) {
      pair.press = a_;
      for (const std::vector<Point>& piece : furtherPieces())
        pair.further_px += piece.back().x - piece.front().x;
      return pair;
    }
    shareEnds(a_, b_, stroke_, plane_.frame);
    std::tie(pair.press, pair.release) = partUpperLower(a_, b_, std::max(0.75, 0.35 * stroke_));
    if (!locked_) startOnAxis(pair.press, pair.release, plane_.frame.x0, std::max(1.0, 0.6 * stroke_));
    for (const std::vector<Point>& piece : furtherPieces()) {
      pair.further_px += piece.back().x - piece.front().x;
      pair.bottomOutLeftOver = pair.bottomOutLeftOver || isBottomOut(piece);
    }
    pair.leftItsLine = changesLine();
    return pair;
  }

 private:
  double radius() const { return stroke_ / 2 + 0.5; }

  std::vector<Point> bothStrokes() const {
    std::vector<Point> points = a_;
    points.insert(points.end(), b_.begin(), b_.end());
    return points;
  }

  std::vector<Point> follow(const std::vector<Point>& beside, const PathLimits& limits) {
    return directPath(search_, reward_, beside, radius(), limits, stroke_, shared_, plane_.frame);
  }

  /// The rim of a stroke already taken is no second stroke.
  double ownOfSecond() const {
    return b_.size() > 1 ? ownCoverage(b_, rewardBeside(reward_, a_, stroke_ + 1)) : 0;
  }

  /// Returns true if the second stroke returns to the first one near zero force, farther in, and both leave
  /// nothing over: a key that locks.
  bool endsLocked() const {
    if (b_.size() < 2) return false;
    const double width = plane_.frame.width(), height = plane_.frame.height();
    return b_.front().x - a_.front().x > kLocked * width &&
           std::abs(b_.front().y - a_.front().y) < kEquallyLow * height &&
           distance(a_.back(), b_.back()) < kEquallyLow * height && leftOver_px() < kLeftBeside * width;
  }

  /// A long path that both leave out: the part of the loop that a leader or a latch branch cut off.
  std::vector<Point> pieceLeftOut(const PathLimits& anywhere) {
    const double enough = 0.15 * plane_.frame.width();
    if (leftOver_px() < enough) return {};
    std::vector<Point> piece = follow(bothStrokes(), anywhere);
    if (piece.size() > 1 && ownCoverage(piece, rewardBeside(reward_, bothStrokes(), stroke_ + 1)) >= enough)
      return piece;
    return {};
  }

  /// Both strokes must start and end near the outermost ends found.
  PathLimits endsFrom(const std::vector<Point>& third) const {
    const double tolerance = 0.05 * plane_.frame.width();
    double first = a_.front().x, last = a_.back().x;
    const auto reach = [&](const std::vector<Point>& p) {
      first = std::min(first, p.front().x);
      last = std::max(last, p.back().x);
    };
    if (b_.size() > 1 && ownCoverage(b_, rewardBeside(reward_, a_, radius())) > 0.06 * plane_.frame.width())
      reach(b_);
    if (third.size() > 1) reach(third);
    return {0, static_cast<int>(first + tolerance), static_cast<int>(last - tolerance), reward_.width - 1};
  }

  const Structure& structure_;
  const WorkPlane& plane_;
  double stroke_;
  float shared_;
  Plane reward_;
  LiftedSearch search_;
  std::vector<Point> a_, b_;
  bool locked_ = false;
};

}  // namespace

std::pair<std::vector<Point>, std::vector<Point>> partUpperLower(const std::vector<Point>& a,
                                                                 const std::vector<Point>& b,
                                                                 double contact_px) {
  std::vector<TouchingPoints> touches = touchingPoints(a, b, contact_px);
  touches.push_back({a.size() - 1, b.size() - 1});
  std::vector<Point> upper, lower;
  std::size_t a0 = 0, b0 = 0;
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const TouchingPoints c = touches[k];
    const std::size_t last = k + 1 == touches.size() ? 1 : 0;
    const bool aLeft = leftness(a, a0, c.a, b, b0, c.b) >= 0;
    std::vector<Point>& forA = aLeft ? upper : lower;
    std::vector<Point>& forB = aLeft ? lower : upper;
    for (std::size_t i = a0; i < c.a + last; ++i) forA.push_back(a[i]);
    for (std::size_t j = b0; j < c.b + last; ++j) forB.push_back(b[j]);
    a0 = c.a;
    b0 = c.b;
  }
  return {upper, lower};
}

PlanePair findPair(const Structure& structure, const WorkPlane& plane) {
  // Shared pixels are worth more than nothing, so that both strokes follow a shared line to its end.
  PairSearch solid(structure, plane, GapPrice{}, 0.2F);
  if (!solid.run()) return {};
  PlanePair pair = solid.parted();
  // With one stroke alone, or a path left over, and many remaining pixels the other may be dashed, so gaps
  // must cost less.
  const double much = 0.15 * plane.frame.width();
  // Dashes that continue the bottom-outs are what remains; with gaps that cost less, strokes would be led
  // over them, and from one row of dashes to the other.
  if (!pair.release.empty() && pair.bottomOutsCut) return pair;
  if ((!pair.release.empty() && pair.further_px < much) || solid.leftOver_px() < much) return pair;
  PairSearch dashed(structure, plane, GapPrice{0.1F, 0.1F}, 0.05F);
  if (!dashed.run() || dashed.explained_px() < solid.explained_px() + much || !dashed.secondIsDashed())
    return pair;
  pair = dashed.parted();
  pair.dashed = true;
  return pair;
}

}  // namespace detent::importer::trace
