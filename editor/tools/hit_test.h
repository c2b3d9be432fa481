// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Marks under the pointer.

#include <optional>
#include <vector>

#include "editor/canvas/graph_canvas.h"

namespace detent::editor {

inline constexpr double markReach_px = 9;
inline constexpr double curveReach_px = 7;

/// Marks within reach, in the order of a click: slope handles of the selected knot, tactile points, operating
/// and reset point, turns, knots; then by distance.
std::vector<Mark> marksAt(const GraphCanvas& canvas, QPointF at_px, double within_px = markReach_px);

/// A place on a stroke near the pointer (the press if both are equally near).
struct CurveHit {
  Stroke stroke = Stroke::press;
  CurvePoint at;
  double distance_px = 0;
};
std::optional<CurveHit> curveAt(const GraphCanvas& canvas, QPointF at_px, double within_px = curveReach_px);

/// The section of a stroke that contains a displacement.
std::optional<std::size_t> sectionAt(const StrokeValues& values, double displacement_mm);

}  // namespace detent::editor
