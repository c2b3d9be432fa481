// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tells mirrored views of a page from others; importer/rising_axes.h makes mirrored ones. Any thread.

#include "importer/page/raster.h"

namespace detent::importer {

struct Mirrored {
  bool across = false, upsideDown = false;
};

/// By the map of an upright view to its page; neither for views that were turned.
inline Mirrored mirroredBy(const Homography& viewToPage) {
  const Point at = viewToPage({0, 0}), right = viewToPage({1, 0}) - at, down = viewToPage({0, 1}) - at;
  if (cross(right, down) > 0) return {};
  return {right.x < 0, down.y < 0};
}

}  // namespace detent::importer
