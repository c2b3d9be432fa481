// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Curves to polylines. Private to importer/page.

#include <vector>

#include "importer/page/raster.h"

namespace detent::importer {

/// Builds the polylines of one path under a transform.
class PathFlattener {
 public:
  /// Chords deviate from curves by at most `tolerance` (in the plane of `transform`'s result); > 0.
  PathFlattener(const Affine& transform, double tolerance) : transform_(transform), tolerance_(tolerance) {}

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
  void finish(bool closed);

  Affine transform_;
  double tolerance_;
  std::vector<Point> current_;
  std::vector<std::vector<Point>> polylines_;
  std::vector<bool> closed_;
  std::size_t pointCount_ = 0;
};

}  // namespace detent::importer
