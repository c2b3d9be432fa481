// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pieces of line joined end to end into strokes that run from the left of the plot to the right;
// docs/develop/decisions/0303-curves-from-vector-paths.md. Private to importer/trace.

#include <cstddef>
#include <optional>
#include <vector>

#include "importer/trace/vector_pieces.h"

namespace detent::importer {

/// A stroke found in the network, left to right.
struct FoundStroke {
  std::vector<Point> points;
  double from = 0, to = 0;  ///< shares of the plot's width
  double joinCost = 0;      ///< of joins and gaps; 0 is a single line across the plot
  double ownLength = 1;     ///< share of the plot's width not shared with strokes found before
  double sharedLength = 0;  ///< share of the plot's width that is
  double width_px = 1;      ///< of the longest piece
  double slanted = 0;       ///< share of the plot's width that is no level or plumb line
};

/// A line that no stroke uses, though a curve could be drawn with it.
struct UnusedLine {
  std::vector<Point> points;  ///< left to right
  double fresh = 0;           ///< length beside the strokes, share of the diagonal
  bool straight = false;      ///< as leaders are
};

/// All pieces of one colour and dash pattern, cut where others end on them, with the joins between their
/// ends. A stroke is the cheapest path of all: joins cost by the angle they turn, gaps by their length,
/// uncovered travel most.
class PieceNetwork {
 public:
  static constexpr double usualCover = 0.35;  ///< of the plot's width

  PieceNetwork(std::vector<LinePiece> pieces, const PlotPlane& plane);

  /// The best stroke that does not mainly repeat those found before; nothing if none covers so much of the plot's width.
  std::optional<FoundStroke> nextStroke(double leastCover = usualCover);

  /// What no stroke uses, beside grid, letters and level or plumb lines.
  std::vector<UnusedLine> unusedLines() const;

  /// Whether the line covers travel that the stroke does not, bent as curves are or in line with the stroke's end: the rest
  /// of the stroke, broken off.
  bool isRestOf(const FoundStroke& stroke, const UnusedLine& line) const;

 private:
  struct Link {
    std::size_t piece = 0;
    bool atEnd = false;  ///< which end of that piece is met
    double gap = 0;      ///< share of the diagonal
  };
  struct Step {
    std::size_t piece = 0;
    bool forward = true;
  };

  void cutAtTouches();
  void linkTouchingEnds();
  void bridgeGaps();
  /// Links loose ends that `mayMeet` across gaps up to `reach`, share of the diagonal.
  template <class MayMeet>
  void bridgeLooseEnds(double reach, MayMeet mayMeet);
  /// The end (2 * piece + atEnd) meets nothing that could be a curve's continuation.
  bool isLoose(std::size_t id) const;
  std::vector<Link>& linksOf(std::size_t piece, bool atEnd) { return links_[2 * piece + (atEnd ? 1 : 0)]; }
  const std::vector<Link>& linksOf(std::size_t piece, bool atEnd) const {
    return links_[2 * piece + (atEnd ? 1 : 0)];
  }

  Point endOf(std::size_t piece, bool atEnd) const;
  Point outwardDirection(std::size_t piece, bool atEnd) const;
  double touchDistance(const LinePiece& a, const LinePiece& b) const;
  double joinCost(std::size_t from, bool fromEnd, const Link& link) const;
  double walkCost(std::size_t piece, bool forward) const;
  /// The line goes on there as one would draw it: touching, without a sharp turn, in the same thickness.
  bool visiblyGoesOn(std::size_t from, bool fromEnd, const Link& link) const;
  /// A plumb line that leads up from here, long enough to be the bottom-out.
  bool isWallUp(const Link& link) const;
  /// Of beginning or ending a stroke there: what it leaves uncovered, and if the line visibly goes on.
  double endCost(const Step& step, bool atEnd) const;
  void extend(std::vector<Step>& steps, bool atEnd) const;
  FoundStroke strokeAlong(const std::vector<Step>& steps, double cost) const;

  std::vector<LinePiece> pieces_;
  PlotPlane plane_;
  std::vector<std::vector<Link>> links_;  ///< two per piece: at its first and at its last point
  std::vector<int> used_;                 ///< how many strokes run over a piece
  std::vector<double> spans_;             ///< across the plot, shares of its width
};

}  // namespace detent::importer
