// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Joins pieces of line end to end into strokes from left to right;
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
  double joinCost = 0;      ///< cost of joins and gaps; 0 is a single line across the plot
  double ownLength = 1;     ///< share of the plot's width not shared with earlier strokes
  double sharedLength = 0;  ///< share of the plot's width shared with them
  double width_px = 1;      ///< of the longest piece
  double slanted = 0;       ///< share of the plot's width without horizontal and vertical lines
};

/// A line that no stroke uses although it could be part of a curve.
struct UnusedLine {
  std::vector<Point> points;  ///< left to right
  double fresh = 0;           ///< length away from the strokes, share of the diagonal
  bool straight = false;      ///< like leaders
};

/// All pieces of one colour and dash pattern, cut where others end on them, with joins between their ends. A
/// stroke is the cheapest path: joins cost by their angle, gaps by their length, uncovered travel most.
class PieceNetwork {
 public:
  static constexpr double usualCover = 0.35;  ///< share of the plot's width

  PieceNetwork(std::vector<LinePiece> pieces, const PlotPlane& plane);

  /// The best stroke that does not mainly repeat earlier ones; nullopt if none covers this share of the
  /// plot's width.
  std::optional<FoundStroke> nextStroke(double leastCover = usualCover);

  /// Lines that no stroke uses, without grid, letters and horizontal or vertical lines.
  std::vector<UnusedLine> unusedLines() const;

  /// Returns true if the line covers travel that the stroke does not, and is bent or in line with the
  /// stroke's end: the rest of a broken stroke.
  bool isRestOf(const FoundStroke& stroke, const UnusedLine& line) const;

 private:
  struct Link {
    std::size_t piece = 0;
    bool atEnd = false;  ///< true if the piece is met at its last point
    double gap = 0;      ///< share of the diagonal
  };
  struct Step {
    std::size_t piece = 0;
    bool forward = true;
  };

  void cutAtTouches();
  void linkTouchingEnds();
  void bridgeGaps();
  /// Links loose ends accepted by `mayMeet` across gaps up to `reach`, share of the diagonal.
  template <class MayMeet>
  void bridgeLooseEnds(double reach, MayMeet mayMeet);
  /// Returns true if the end (2 * piece + atEnd) meets nothing that could continue a curve.
  bool isLoose(std::size_t id) const;
  std::vector<Link>& linksOf(std::size_t piece, bool atEnd) { return links_[2 * piece + (atEnd ? 1 : 0)]; }
  const std::vector<Link>& linksOf(std::size_t piece, bool atEnd) const {
    return links_[2 * piece + (atEnd ? 1 : 0)];
  }

  Point endOf(std::size_t piece, bool atEnd) const;
  Point outwardDirection(std::size_t piece, bool atEnd) const;
  double touchDistance(const LinePiece& a, const LinePiece& b) const;
  double joinCost(std::size_t from, bool fromEnd, const Link& link) const;
  double pathCost(std::size_t piece, bool forward) const;
  /// Returns true if the line visibly continues: touching, without a sharp turn, with the same thickness.
  bool visiblyGoesOn(std::size_t from, bool fromEnd, const Link& link) const;
  /// Returns true for a vertical line upwards, long enough for the bottom-out.
  bool isBottomOutUp(const Link& link) const;
  /// Cost of beginning or ending a stroke there: uncovered travel, and more if the line visibly continues.
  double endCost(const Step& step, bool atEnd) const;
  void extend(std::vector<Step>& steps, bool atEnd) const;
  FoundStroke strokeAlong(const std::vector<Step>& steps, double cost) const;

  std::vector<LinePiece> pieces_;
  PlotPlane plane_;
  std::vector<std::vector<Link>> links_;  ///< two per piece: at its first and at its last point
  std::vector<int> used_;                 ///< number of strokes on each piece
  std::vector<double> spans_;             ///< across the plot, shares of its width
};

}  // namespace detent::importer
