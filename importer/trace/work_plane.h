// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The reduced plane on which both strokes of a loop are searched: one colour's coverage of the plot area,
// reduced by a whole factor to a width of some hundred pixels.

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

struct WorkPlane {
  Plane coverage;    ///< coverage 0..1; paper outside the area
  Box frame;         ///< the frame's edges in plane px
  double scale = 1;  ///< area pixels per plane pixel, whole
  Point origin;      ///< of the plane, in area pixels

  Point toArea(Point plane_px) const { return origin + scale * plane_px; }
  Point fromArea(Point area_px) const { return (1 / scale) * (area_px - origin); }
};

struct WorkPlaneOptions {
  int maxWidth_px = 520;  ///< of the frame on the plane; [64, 4096]
};

/// From one colour's coverage of the area.
WorkPlane makeWorkPlane(const Plane& coverage, const PlotArea& area, const WorkPlaneOptions& options = {});

}  // namespace detent::importer::trace
