// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The ink of one curve on the plot area, and how thick lines of it are. Private to importer/trace.

#include <vector>

#include "importer/trace/backdrop.h"
#include "importer/trace/ink_palette.h"

namespace detent::importer::trace {

/// Ink across a line: coverage summed, and its centre of mass.
struct InkRun {
  double thickness_px = 0;
  double middle = 0;
};

/// How much of one curve's ink the area's pixels hold. Refers to what it was made of.
class CurveInkOnArea {
 public:
  CurveInkOnArea(const PlotArea& area, const Backdrop& backdrop, Rgb color);

  /// Whether the colour stands out of the paper.
  bool distinct() const { return ink_.strength > 40; }
  /// Coverage, 0..1; 0 outside the area and in other colours.
  float at(int x, int y) const;
  /// The run of ink that holds the place or lies within two pixels of it, across a plumb or a level line.
  InkRun across(double x, double y, bool plumb) const;
  /// How thick a line along these points is drawn, area px; 0 where it is not seen.
  double thicknessAlong(const std::vector<Point>& points) const;

 private:
  const PlotArea& area_;
  const Backdrop& backdrop_;
  Ink ink_;
};

/// What stands on a column of the area.
class PlumbLane {
 public:
  PlumbLane(const CurveInkOnArea& ink, const PlotArea& area, double x) : ink_(ink), area_(area), x_(x) {}

  /// Thicknesses of its rows between two, those of level lines of the plot apart.
  std::vector<double> rows(double y0, double y1) const;
  /// The row up to which every row from `foot` on has at least so much ink, gaps up to `gap_px` apart.
  double top(double foot, double least_px, double gap_px) const;
  /// Sub-pixel place of the lane's ink between two rows.
  double middle(double y0, double y1) const;

 private:
  bool onLevelLine(double y) const;

  const CurveInkOnArea& ink_;
  const PlotArea& area_;
  double x_;
};

}  // namespace detent::importer::trace
