// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/dashes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "importer/page/pixel_components.h"
#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

constexpr double kDashCoverage = 0.25;  // coverage
constexpr std::size_t kFewestPieces = 8,
                      kMostPieces = 1500;  // pieces of a dashed line, and of a line that is not noise
constexpr double kLargestShare = 0.25;     // share of the coverage, in one dash
constexpr double kDustShare = 0.2;         // share of the usual dash's area
constexpr double kLongestGap = 2.5;        // in usual gaps; one dash may be hidden
// Share of gaps within 0.4 (or 1.5 px) of the usual one: of dashes at least 0.81, of coloured rims of letters
// at most 0.32.
constexpr double kRegularShare = 0.75, kRegularWithin = 0.4, kRegularWithin_px = 1.5;

/// A connected piece, represented by its outermost pixels in eight directions.
struct Piece {
  std::array<Point, 8> rim;
  double area_px = 0;
};

/// The two nearest pixels of two pieces.
struct Gap {
  Point from, to;
  double length_px = std::numeric_limits<double>::max();
};

std::vector<Piece> dashPieces(const Plane& own) {
  const cv::Mat covered = matOf(own) > kDashCoverage;
  const PixelComponents found = pixelComponentsOf(covered.data, covered.cols, covered.rows, covered.step);
  std::vector<Piece> pieces(found.all.size());
  constexpr std::array<Point, 8> outward{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  for (const PixelRun& run : found.runs) {
    Piece& piece = pieces[run.piece];
    for (const int x : {run.from, run.to - 1}) {
      const Point p{static_cast<double>(x), static_cast<double>(run.y)};
      for (std::size_t k = 0; k < outward.size(); ++k)
        if (piece.area_px == 0 || dot(p, outward[k]) > dot(piece.rim[k], outward[k])) piece.rim[k] = p;
      piece.area_px = found.all[run.piece].area_px;
    }
  }
  return pieces;
}

/// Returns true if the pieces are dashes; removes dust from them.
bool keepDashes(std::vector<Piece>& pieces) {
  if (pieces.size() < kFewestPieces || pieces.size() > kMostPieces) return false;
  std::vector<double> areas;
  double all_px = 0;
  for (const Piece& piece : pieces) {
    areas.push_back(piece.area_px);
    all_px += piece.area_px;
  }
  if (*std::ranges::max_element(areas) > kLargestShare * all_px) return false;
  const double dust_px = kDustShare * medianOf(areas);
  std::erase_if(pieces, [&](const Piece& piece) { return piece.area_px < dust_px; });
  return pieces.size() >= kFewestPieces;
}

Gap gapBetween(const Piece& a, const Piece& b) {
  Gap nearest;
  for (Point p : a.rim)
    for (Point q : b.rim)
      if (const double length_px = distance(p, q); length_px < nearest.length_px) nearest = {p, q, length_px};
  return nearest;
}

/// The shortest tree that joins all pieces (Prim 1957).
std::vector<Gap> shortestTree(const std::vector<Piece>& pieces) {
  std::vector<Gap> tree, toTree(pieces.size());
  std::vector<char> joined(pieces.size(), 0);
  for (std::size_t newest = 0; tree.size() + 1 < pieces.size();) {
    joined[newest] = 1;
    std::size_t next = newest;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (joined[k]) continue;
      const Gap gap = gapBetween(pieces[newest], pieces[k]);
      if (gap.length_px < toTree[k].length_px) toTree[k] = gap;
      if (next == newest || toTree[k].length_px < toTree[next].length_px) next = k;
    }
    tree.push_back(toTree[next]);
    newest = next;
  }
  return tree;
}

void fillDash(Plane& plane, const Gap& gap) {
  const int steps = std::max(1, static_cast<int>(std::ceil(2 * gap.length_px)));
  for (int i = 0; i <= steps; ++i) {
    const Point p = gap.from + (static_cast<double>(i) / steps) * (gap.to - gap.from);
    plane.at(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))) = 1;
  }
}

}  // namespace

std::optional<Plane> withDashesJoined(const Plane& own) {
  std::vector<Piece> pieces = dashPieces(own);
  if (!keepDashes(pieces)) return {};
  const std::vector<Gap> gaps = shortestTree(pieces);
  std::vector<double> lengths;
  for (const Gap& gap : gaps) lengths.push_back(gap.length_px);
  const double usual_px = medianOf(std::move(lengths));
  const auto regular = std::ranges::count_if(gaps, [&](const Gap& gap) {
    return std::abs(gap.length_px - usual_px) <= std::max(kRegularWithin_px, kRegularWithin * usual_px);
  });
  if (static_cast<double>(regular) < kRegularShare * static_cast<double>(gaps.size())) return {};
  Plane joined = own;
  for (const Gap& gap : gaps)
    if (gap.length_px <= kLongestGap * usual_px) fillDash(joined, gap);
  return joined;
}

}  // namespace detent::importer::trace
