// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/vector_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "importer/page/clip_line.h"
#include "importer/trace/filled_outline.h"

namespace detent::importer {
namespace {

constexpr double overshoot = 0.04;           // of the plot's size; how far a curve may leave the frame
constexpr double turnRound = 0.05;           // of the plot's width; shorter returns are wiggles
constexpr double letterSize = 0.025;         // of the plot's diagonal
constexpr double outlinedLetterSize = 0.06;  // the same
constexpr double shortestFoldArm = 0.01;     // of the plot's diagonal

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
  int heading = 0;  // -1 leftwards, 1 rightwards, 0 not known yet
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double gain = line[i].x - line[extreme].x;
    if (heading == 0) {
      const double moved = line[i].x - line[begin].x;
      if (std::abs(moved) > minReturn_px) heading = moved > 0 ? 1 : -1;
      if (std::abs(moved) >= std::abs(line[extreme].x - line[begin].x)) extreme = i;
      continue;
    }
    // On a wall the turn is at its far end from where the line came: the last of the points that lie equally
    // far.
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

/// Cuts where the line folds back on itself between two long straight arms: strokes that begin in one point. A line that goes
/// on to the same side is one stroke, however steeply its force drops there.
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

/// Frames, legend boxes, text backgrounds, grids drawn as one long line: nothing but long level and plumb
/// segments. A curve of many short steps leaves its way by less than a thick line's tolerance at each of them: these slant.
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

bool nearAny(const std::vector<double>& positions, double at, double tolerance) {
  return std::any_of(positions.begin(), positions.end(),
                     [&](double p) { return std::abs(p - at) <= tolerance; });
}

/// Turns whole polylines into pieces.
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
        !isStraight(line, tolerance))
      return;
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
    for (const Polyline& part : parts)
      for (Polyline& run : cutAtTurns(part, turnRound * plane_.box.width()))
        for (Polyline& arm : cutAtFolds(run, shortestFoldArm * plane_.diagonal()))
          store(arm, path, width_px, color);
  }

  std::vector<LinePiece> take() {
    for (LinePiece& piece : pieces_)
      if (piece.onGridLine && beginsWhereAStrokeEnds(piece)) piece.onGridLine = false;
    return std::move(pieces_);
  }

 private:
  static bool isStraight(const Polyline& line, double tolerance) {
    const Box bounds = boundsOf(line);
    return std::min(bounds.width(), bounds.height()) <= tolerance;
  }

  /// A plumb piece one of whose ends lies in the plot, where a curve of its ink ends: a wall drawn by itself. Gridlines end at the
  /// plot's edges.
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

  void store(const Polyline& line, const VectorPath& path, double width_px, Rgb color) {
    LinePiece piece;
    piece.points = withoutRepeats(line);
    if (piece.points.size() < 2) return;
    const Box bounds = boundsOf(piece.points);
    const double tolerance = std::max(0.05, 0.25 * width_px);
    piece.color = color;
    piece.width_px = width_px;
    piece.dashed = path.dashed;
    // The stem of a large letter that is an outline is a long thin shape too.
    const double smallest = path.stroke ? letterSize : outlinedLetterSize;
    piece.small = std::hypot(bounds.width(), bounds.height()) < smallest * plane_.diagonal();
    piece.axisParallel = isStraight(piece.points, tolerance);
    if (piece.axisParallel) {
      const double reach = std::max(1.0, width_px);
      const bool plumb = bounds.width() <= bounds.height();
      piece.onGridLine = plumb ? nearAny(plane_.columns_px, piece.points[0].x, reach)
                               : nearAny(plane_.rows_px, piece.points[0].y, reach);
    }
    pieces_.push_back(std::move(piece));
  }

  const PlotPlane& plane_;
  const std::vector<Box>& masks_;
  Box region_;
  std::vector<LinePiece> pieces_;
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
      if (path.stroke && path.fill && path.closed[i]) continue;  // a shape with a border
      if (path.stroke) {
        maker.add(path.polylines[i], path.closed[i], path, path.strokeWidth, *path.stroke);
      } else if (path.fill) {
        const auto centre = centreOfOutline(path.polylines[i], 0.02 * plane.diagonal());
        if (centre && lengthOf(centre->points) > 0.2 * letterSize * plane.diagonal())
          maker.add(centre->points, false, path, centre->width_px, *path.fill);
      }
    }
  }
  return maker.take();
}

}  // namespace detent::importer
