// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What lies under the pointer.

#include <optional>
#include <vector>

#include "editor/canvas/graph_canvas.h"

namespace detent::editor {

inline constexpr double markReach_px = 9;
inline constexpr double curveReach_px = 7;

/// Marks within reach, the one a click takes first: slope handles of the selected knot, then tactile points,
/// operating and reset point, turns, knots; among equals the nearest.
std::vector<Mark> marksAt(const GraphCanvas& canvas, QPointF at_px, double within_px = markReach_px);

/// A place on a stroke near the pointer (press first where both are equally near).
struct CurveHit {
  Stroke stroke = Stroke::press;
  CurvePoint at;
  double distance_px = 0;
};
std::optional<CurveHit> curveAt(const GraphCanvas& canvas, QPointF at_px, double within_px = curveReach_px);

/// The section of a stroke that holds a displacement.
std::optional<std::size_t> sectionAt(const StrokeValues& values, double displacement_mm);

}  // namespace detent::editor
