// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Curves to polylines. Private to importer/page.

#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// Builds the polylines of one path under a transform. Damaged pages may have points at enormous distances,
/// so lines are cut at the edge of the area that is needed.
class PathFlattener {
 public:
  /// Chords deviate from curves by at most `tolerance` (in the plane of `transform`'s result); > 0.
  /// Inside `within` the lines run as drawn; finite points outside are moved to its edge.
  PathFlattener(const Affine& transform, double tolerance, const Box& within)
      : transform_(transform), tolerance_(tolerance), within_(within) {}

  void moveTo(Point p);
  void lineTo(Point p);
  void curveTo(Point control1, Point control2, Point end);
  void close();

  /// Subpaths of at least two points.
  std::vector<std::vector<Point>> takePolylines();
  std::vector<bool> takeClosed() { return std::move(closed_); }
  std::size_t pointCount() const { return pointCount_; }

 private:
  void add(Point transformed);
  void addCrossings(Point next);
  void finish(bool closed);

  Affine transform_;
  double tolerance_;
  Box within_;
  Point start_, last_;  ///< first and last point of the current subpath, as drawn
  std::vector<Point> current_;
  std::vector<std::vector<Point>> polylines_;
  std::vector<bool> closed_;
  std::size_t pointCount_ = 0;
};

}  // namespace detent::importer
