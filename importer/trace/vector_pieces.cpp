// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/vector_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "importer/page/clip_line.h"
#include "importer/trace/dashed_pieces.h"
#include "importer/trace/filled_outline.h"

namespace detent::importer {
namespace {

constexpr double overshoot = 0.04;           // share of the plot's size by which a curve may leave the frame
constexpr double turnRound = 0.05;           // share of the plot's width; shorter returns are ignored
constexpr double letterSize = 0.025;         // share of the plot's diagonal
constexpr double outlinedLetterSize = 0.06;  // share of the plot's diagonal
constexpr double shortestFoldArm = 0.01;     // share of the plot's diagonal

/// The parts of the line outside the box.
std::vector<Polyline> cutOut(const Polyline& line, const Box& box) {
  std::vector<Polyline> parts;
  const auto extend = [&](Point a, Point b) {
    if (parts.empty() || distance(parts.back().back(), a) > 1e-9) parts.push_back({a});
    parts.back().push_back(b);
  };
  for (std::size_t i = 1; i < line.size(); ++i) {
    double from = 0, to = 1;
    const Point a = line[i - 1], b = line[i];
    if (!insideSpan(a, b, box, from, to)) {
      extend(a, b);
      continue;
    }
    if (from > 0) extend(a, pointBetween(a, b, from));
    if (to < 1) extend(pointBetween(a, b, to), b);
  }
  return parts;
}

/// Cuts where x turns round: a loop drawn as one line becomes its two strokes.
std::vector<Polyline> cutAtTurns(const Polyline& line, double minReturn_px) {
  std::vector<Polyline> parts;
  std::size_t begin = 0, extreme = 0;
  int heading = 0;  // -1 leftwards, 1 rightwards, 0 unknown
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double gain = line[i].x - line[extreme].x;
    if (heading == 0) {
      const double moved = line[i].x - line[begin].x;
      if (std::abs(moved) > minReturn_px) heading = moved > 0 ? 1 : -1;
      if (std::abs(moved) >= std::abs(line[extreme].x - line[begin].x)) extreme = i;
      continue;
    }
    // On a vertical stretch the turn is at its far end: the last of the equally far points.
    if (gain * heading >= 0) {
      extreme = i;
    } else if (-gain * heading > minReturn_px) {
      parts.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(begin),
                         line.begin() + static_cast<std::ptrdiff_t>(extreme) + 1);
      begin = extreme;
      extreme = i;
      heading = -heading;
    }
  }
  parts.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end());
  return parts;
}

/// Cuts where the line folds back between two long straight arms: strokes that begin in one point. A line
/// that continues to the same side is one stroke, however steeply its force drops there.
std::vector<Polyline> cutAtFolds(const Polyline& line, double leastArm_px) {
  constexpr double foldCosine = -0.64;  // turns by more than 130°
  std::vector<Polyline> parts;
  std::size_t begin = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Point in = line[i] - line[i - 1], out = line[i + 1] - line[i];
    const double inLength = norm(in), outLength = norm(out);
    if (inLength < leastArm_px || outLength < leastArm_px) continue;
    if (in.x * out.x > 0 || dot(in, out) > foldCosine * inLength * outLength) continue;
    parts.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(begin),
                       line.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    begin = i;
  }
  parts.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end());
  return parts;
}

/// Returns true for frames, legend boxes, text backgrounds, and grids drawn as one long line: only long
/// horizontal and vertical segments. Short steps of a curve deviate by less than the tolerance each, but
/// slant.
bool onlyLongAxisParallel(const Polyline& line, double tolerance_px, double longLength_px) {
  constexpr double slant = 0.1, mostSlanted = 0.1;  // across to along; of the line's length
  bool anyLong = false;
  double length_px = 0, slanted_px = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double dx = std::abs(line[i].x - line[i - 1].x), dy = std::abs(line[i].y - line[i - 1].y);
    const auto [across, along] = std::minmax(dx, dy);
    if (across > tolerance_px) return false;
    if (along > longLength_px) anyLong = true;
    length_px += along;
    if (across > slant * along) slanted_px += along;
  }
  return anyLong && slanted_px <= mostSlanted * length_px;
}

/// Returns true if the sides of a short outline, which cross at a bend, gave a line that turns back or does
/// not run from end to end.
bool isTangled(const Polyline& line, const Polyline& outline, double short_px) {
  constexpr double leastExtent = 0.8;  // of the outline's
  const auto extentOf = [](const Box& box) { return std::hypot(box.width(), box.height()); };
  const double extent_px = extentOf(boundsOf(outline));
  if (extent_px > short_px) return false;
  int back = 0;
  for (std::size_t i = 2; i < line.size(); ++i)
    back += dot(line[i - 1] - line[i - 2], line[i] - line[i - 1]) < 0 ? 1 : 0;
  return back > 1 || extentOf(boundsOf(line)) < leastExtent * extent_px;
}

/// The upper side of an area with a border: without its horizontal base, and the vertical sides at its right
/// and on the plot's left edge. nullopt if a shape is no such area, or as small as a marker.
std::optional<Polyline> upperSide(Polyline ring, const Box& plot) {
  constexpr double level_px = 0.5, nearlyAll = 0.98;  // of the width
  constexpr double least = 0.12;                      // share of the plot's width
  if (ring.empty()) return {};
  if (distance(ring.front(), ring.back()) > 1e-9) ring.push_back(ring.front());
  const Box box = boundsOf(ring);
  if (box.width() < least * plot.width()) return {};
  const auto onBottomEdge = [&](Point p) { return p.y > box.y1 - level_px; };
  const auto bottomSide = std::adjacent_find(ring.begin(), ring.end(), [&](Point a, Point b) {
    return onBottomEdge(a) && onBottomEdge(b) && std::abs(b.x - a.x) >= nearlyAll * box.width();
  });
  if (bottomSide == ring.end()) return {};
  // The outline without its base edge, from one end of the base to the other. The ring's last point repeats
  // its first.
  Polyline upper(bottomSide + 1, ring.end());
  upper.insert(upper.end(), ring.begin() + 1, bottomSide + 1);
  if (upper.size() > 2 && upper.front().x > upper.back().x) std::reverse(upper.begin(), upper.end());
  const auto isSide = [&](Point end, Point next) {
    return onBottomEdge(end) && !onBottomEdge(next) && std::abs(end.x - next.x) < level_px;
  };
  while (upper.size() > 2 && isSide(upper.back(), upper[upper.size() - 2])) upper.pop_back();
  if (upper.size() > 2 && std::abs(upper[0].x - plot.x0) < level_px && isSide(upper[0], upper[1]))
    upper.erase(upper.begin());
  return upper;
}

bool nearAny(const std::vector<double>& positions, double at, double tolerance) {
  return std::any_of(positions.begin(), positions.end(),
                     [&](double p) { return std::abs(p - at) <= tolerance; });
}

/// Converts whole polylines to pieces.
class PieceMaker {
 public:
  PieceMaker(const PlotPlane& plane, const std::vector<Box>& masks) : plane_(plane), masks_(masks) {
    region_ = plane.box.grown(overshoot * plane.box.width(), overshoot * plane.box.height());
  }

  void add(const Polyline& whole, bool closed, const VectorPath& path, double width_px, Rgb color) {
    Polyline line = withoutRepeats(whole);
    if (line.size() < 2) return;
    if (closed && distance(line.front(), line.back()) > 1e-9) line.push_back(line.front());
    const double tolerance = std::max(0.05, 0.25 * width_px);
    const Box bounds = boundsOf(line);
    const bool letter = std::hypot(bounds.width(), bounds.height()) < letterSize * plane_.diagonal();
    const bool loop = distance(line.front(), line.back()) < 1e-6;
    if (loop && letter) return;
    if (line.size() > 2 && onlyLongAxisParallel(line, tolerance, letterSize * plane_.diagonal()) &&
        !isStraight(line, tolerance)) {
      for (std::size_t i = 1; i < line.size(); ++i)
        boxSides_.push_back({.points = {line[i - 1], line[i]}, .color = color, .width_px = width_px});
      return;
    }
    Box window = region_;
    if (path.clip) window = window.common(*path.clip);
    if (window.empty()) return;
    std::vector<Polyline> parts = clippedLine(line, window);
    for (const Box& mask : masks_) {
      std::vector<Polyline> rest;
      for (const Polyline& part : parts)
        for (Polyline& outside : cutOut(part, mask)) rest.push_back(std::move(outside));
      parts = std::move(rest);
    }
    // The stem of a large outlined letter is a long thin shape too.
    for (const Polyline& part : parts)
      addCut(part, {path.dashed, path.stroke ? letterSize : outlinedLetterSize, width_px, color});
  }

  /// A filled shape that is no line by itself: a dot, or a dash too short or too bent for its outline.
  void addDash(const Polyline& ring, Rgb color) {
    auto dash = dashOfOutline(ring, outlinedLetterSize * plane_.diagonal());
    if (!dash) return;
    const Point at = dash->points.front();
    const auto covers = [&](const Box& mask) { return mask.contains(at); };
    if (region_.contains(at) && std::ranges::none_of(masks_, covers))
      dashes_.push_back({color, std::move(*dash), {}});
  }

  std::vector<LinePiece> take() {
    joinSteps();
    joinDashes();
    for (LinePiece& piece : pieces_)
      if (piece.onGridLine && beginsWhereAStrokeEnds(piece) && !isHidden(piece)) piece.onGridLine = false;
    return std::move(pieces_);
  }

 private:
  static bool isStraight(const Polyline& line, double tolerance) {
    const Box bounds = boundsOf(line);
    return std::min(bounds.width(), bounds.height()) <= tolerance;
  }

  /// Returns true for a vertical piece with an end inside the plot, where a curve of its colour ends: a
  /// bottom-out drawn separately. Gridlines end at the plot's edges.
  bool beginsWhereAStrokeEnds(const LinePiece& piece) const {
    const Box bounds = boundsOf(piece.points);
    if (bounds.width() > bounds.height()) return false;
    const double reach_px = std::max(0.1, 0.25 * piece.width_px);
    const Box inside = plane_.box.grown(0, -2 * std::max(1.0, piece.width_px));
    const auto endsAt = [&](Point end) {
      return std::ranges::any_of(pieces_, [&](const LinePiece& other) {
        return !other.axisParallel && other.color == piece.color &&
               std::min(distance(other.points.front(), end), distance(other.points.back(), end)) <= reach_px;
      });
    };
    return std::ranges::any_of(std::array{piece.points.front(), piece.points.back()}, [&](Point end) {
      return end.y > inside.y0 && end.y < inside.y1 && endsAt(end);
    });
  }

  /// Returns true for a vertical piece all of which a line of the plot shows as well: in its colour, at least
  /// as thick, and longer. Nobody sees whether it is there.
  bool isHidden(const LinePiece& piece) const {
    constexpr double leastThick = 0.9, longer = 1.05;  // times the piece's
    const Box own = boundsOf(piece.points);
    const auto hides = [&](const LinePiece& line) {
      const Box box = boundsOf(line.points);
      return !line.dashed && line.color == piece.color && line.width_px >= leastThick * piece.width_px &&
             std::max(std::abs(box.x0 - own.x0), std::abs(box.x1 - own.x1)) < 0.5 * piece.width_px &&
             box.height() >= longer * own.height() && box.y0 <= own.y0 + piece.width_px &&
             box.y1 >= own.y1 - piece.width_px;
    };
    return std::ranges::any_of(pieces_, hides) || std::ranges::any_of(boxSides_, hides);
  }

  /// Drawing of a line, and the size (share of the plot's diagonal) below which it is a letter.
  struct Drawn {
    bool dashed = false;
    double letter = letterSize, width_px = 1;
    Rgb color;
  };

  void addCut(const Polyline& line, const Drawn& as) {
    for (Polyline& run : cutAtTurns(line, turnRound * plane_.box.width()))
      for (Polyline& arm : cutAtFolds(run, shortestFoldArm * plane_.diagonal())) store(arm, as);
  }

  /// A curve drawn step by step, each from the end of the last, is one line.
  void joinSteps() {
    constexpr std::size_t fewest = 8;
    constexpr double touching_px = 0.01;
    const auto goesOn = [&](const LinePiece& a, const LinePiece& b) {
      return a.color == b.color && a.width_px == b.width_px && a.dashed == b.dashed &&
             distance(a.points.back(), b.points.front()) <= touching_px;
    };
    std::vector<LinePiece> steps = std::move(pieces_);
    pieces_.clear();
    for (auto from = steps.begin(); from != steps.end();) {
      auto last = from;
      Polyline line = from->points;
      while (last + 1 != steps.end() && goesOn(*last, *(last + 1))) {
        ++last;
        line.insert(line.end(), last->points.begin(), last->points.end());
      }
      const Box bounds = boundsOf(line);
      const bool letter = std::hypot(bounds.width(), bounds.height()) < letterSize * plane_.diagonal();
      if (static_cast<std::size_t>(last - from) + 1 >= fewest && !letter)
        addCut(line, {from->dashed, letterSize, from->width_px, from->color});
      else
        std::move(from, last + 1, std::back_inserter(pieces_));
      from = last + 1;
    }
  }

  /// Dashes drawn one by one become one line, like a dash pattern.
  void joinDashes() {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (!pieces_[i].dashed && lengthOf(pieces_[i].points) <= outlinedLetterSize * plane_.diagonal())
        dashes_.push_back({pieces_[i].color, {pieces_[i].points, pieces_[i].width_px}, i});
    std::vector<char> joined(pieces_.size(), 0);
    std::vector<LinePiece> kept;
    std::stable_sort(dashes_.begin(), dashes_.end(),
                     [](const Dash& a, const Dash& b) { return orderOf(a.color) < orderOf(b.color); });
    for (auto from = dashes_.begin(); from != dashes_.end();) {
      const auto to =
          std::find_if(from, dashes_.end(), [&](const Dash& d) { return d.color != from->color; });
      std::vector<DashPiece> ofColour;
      for (auto it = from; it != to; ++it) ofColour.push_back(it->drawn);
      for (const DashedLine& line : dashedLines(ofColour)) {
        for (const std::size_t member : line.members)
          if (const auto piece = from[static_cast<std::ptrdiff_t>(member)].piece) joined[*piece] = 1;
        addCut(line.points, {true, letterSize, line.width_px, from->color});
      }
      from = to;
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (i >= joined.size() || !joined[i]) kept.push_back(std::move(pieces_[i]));
    pieces_ = std::move(kept);
  }

  void store(const Polyline& line, const Drawn& as) {
    LinePiece piece;
    piece.points = withoutRepeats(line);
    if (piece.points.size() < 2) return;
    const Box bounds = boundsOf(piece.points);
    const double tolerance = std::max(0.05, 0.25 * as.width_px);
    piece.color = as.color;
    piece.width_px = as.width_px;
    piece.dashed = as.dashed;
    piece.small = std::hypot(bounds.width(), bounds.height()) < as.letter * plane_.diagonal();
    piece.axisParallel = isStraight(piece.points, tolerance);
    if (piece.axisParallel) {
      const double reach = std::max(1.0, as.width_px);
      const bool plumb = bounds.width() <= bounds.height();
      piece.onGridLine = plumb ? nearAny(plane_.columns_px, piece.points[0].x, reach)
                               : nearAny(plane_.rows_px, piece.points[0].y, reach);
    }
    pieces_.push_back(std::move(piece));
  }

  /// A possible dash, and its piece.
  struct Dash {
    Rgb color;
    DashPiece drawn;
    std::optional<std::size_t> piece;
  };
  static std::array<std::uint8_t, 3> orderOf(Rgb color) { return {color.r, color.g, color.b}; }

  const PlotPlane& plane_;
  const std::vector<Box>& masks_;
  Box region_;
  std::vector<LinePiece> pieces_;
  std::vector<LinePiece> boxSides_;  ///< of frames and boxes, which are no pieces
  std::vector<Dash> dashes_;
};

}  // namespace

PlotPlane::PlotPlane(const PlotFrame& frame) {
  box = frame.box();
  columns_px = {box.x0, box.x1};
  rows_px = {box.y0, box.y1};
  for (const GridLine& line : frame.xLines)
    if (line.spansFrame) columns_px.push_back(line.position_px);
  for (const GridLine& line : frame.yLines)
    if (line.spansFrame) rows_px.push_back(line.position_px);
}

double PlotPlane::diagonal() const { return std::hypot(box.width(), box.height()); }

std::vector<LinePiece> linePieces(const PageView& view, const PlotPlane& plane,
                                  const std::vector<Box>& masks_px) {
  PieceMaker maker(plane, masks_px);
  const Box near = plane.box.grown(overshoot * plane.box.width(), overshoot * plane.box.height());
  for (const VectorPath& path : view.paths) {
    if (!path.box.touches(near)) continue;
    for (std::size_t i = 0; i < path.polylines.size(); ++i) {
      if (path.stroke && path.fill && path.closed[i]) {  // a shape with a border
        if (const auto upper = upperSide(path.polylines[i], plane.box))
          maker.add(*upper, false, path, path.strokeWidth, *path.stroke);
      } else if (path.stroke) {
        maker.add(path.polylines[i], path.closed[i], path, path.strokeWidth, *path.stroke);
      } else if (path.fill) {
        const auto centre = centreOfOutline(path.polylines[i], 0.02 * plane.diagonal());
        if (centre && lengthOf(centre->points) > 0.2 * letterSize * plane.diagonal() &&
            !isTangled(centre->points, path.polylines[i], outlinedLetterSize * plane.diagonal()))
          maker.add(centre->points, false, path, centre->width_px, *path.fill);
        else
          maker.addDash(path.polylines[i], *path.fill);
      }
    }
  }
  return maker.take();
}

}  // namespace detent::importer
