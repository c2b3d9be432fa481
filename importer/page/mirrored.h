// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Detects whether a view shows its page mirrored. importer/rising_axes.h makes such views. Any thread.

#include "importer/page/raster.h"

namespace detent::importer {

struct Mirrored {
  bool across = false;      ///< left and right are exchanged
  bool upsideDown = false;  ///< top and bottom are exchanged
};

/// Detects the mirroring from the map of an upright view to its page. Neither flag is set for a view that was
/// only turned.
inline Mirrored mirroredBy(const Homography& viewToPage) {
  const Point at = viewToPage({0, 0}), right = viewToPage({1, 0}) - at, down = viewToPage({0, 1}) - at;
  if (cross(right, down) > 0) return {};
  return {right.x < 0, down.y < 0};
}

}  // namespace detent::importer
