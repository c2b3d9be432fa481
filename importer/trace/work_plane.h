// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The small plane on which both strokes of a loop are searched for: one ink's coverage of the plot area, shrunk
// by a whole factor, so that a frame is at most some hundred pixels wide.

#include "importer/trace/plot_area.h"

namespace detent::importer::trace {

struct WorkPlane {
  Plane ink;         ///< coverage 0..1; paper outside the area
  Box frame;         ///< the frame's edges in plane px
  double scale = 1;  ///< area pixels per plane pixel, whole
  Point origin;      ///< of the plane, in area pixels

  Point toArea(Point plane_px) const { return origin + scale * plane_px; }
  Point fromArea(Point area_px) const { return (1 / scale) * (area_px - origin); }
};

struct WorkPlaneOptions {
  int maxWidth_px = 520;  ///< of the frame on the plane; [64, 4096]
};

/// `ink`: one ink's coverage of the area.
WorkPlane makeWorkPlane(const Plane& ink, const PlotArea& area, const WorkPlaneOptions& options = {});

}  // namespace detent::importer::trace
