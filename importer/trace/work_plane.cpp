// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/work_plane.h"

#include <algorithm>
#include <cmath>

namespace detent::importer::trace {

namespace {

/// Mean of factor x factor blocks starting at (left, top); outside the plane is paper.
Plane shrunkBlocks(const Plane& coverage, int left, int top, int width, int height, int factor) {
  Plane out(width, height);
  const float share = 1.0F / static_cast<float>(factor * factor);
  for (int v = 0; v < height; ++v) {
    for (int dy = 0; dy < factor; ++dy) {
      const int y = top + v * factor + dy;
      if (y < 0 || y >= coverage.height) continue;
      for (int u = 0; u < width; ++u) {
        const int x0 = std::max(0, left + u * factor), x1 = std::min(coverage.width, left + (u + 1) * factor);
        float sum = 0;
        for (int x = x0; x < x1; ++x) sum += coverage.at(x, y);
        out.at(u, v) += sum * share;
      }
    }
  }
  return out;
}

}  // namespace

WorkPlane makeWorkPlane(const Plane& coverage, const PlotArea& area, const WorkPlaneOptions& options) {
  const Box& f = area.frame;
  const double extent = std::max(f.width(), f.height());
  const int factor = std::max(1, static_cast<int>(std::ceil(extent / options.maxWidth_px - 0.15)));
  const double margin = PlotArea::marginPx * factor;
  const int x0 = static_cast<int>(std::floor(f.x0 - margin)),
            y0 = static_cast<int>(std::floor(f.y0 - margin));
  const int width = static_cast<int>(std::ceil((f.x1 + margin - x0 + 1) / factor));
  const int height = static_cast<int>(std::ceil((f.y1 + margin - y0 + 1) / factor));
  WorkPlane plane;
  plane.coverage = shrunkBlocks(coverage, x0, y0, width, height, factor);
  plane.scale = factor;
  plane.origin = {x0 + 0.5 * (factor - 1), y0 + 0.5 * (factor - 1)};
  const Point a = plane.fromArea({f.x0, f.y0}), b = plane.fromArea({f.x1, f.y1});
  plane.frame = {a.x, a.y, b.x, b.y};
  return plane;
}

}  // namespace detent::importer::trace
