// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Derived values of a force graph for the views, computed once per change.

#include <optional>
#include <vector>

#include "model/button.h"
#include "model/sections.h"

namespace detent::editor {

/// Derived values of one stroke. Tactile points and sections in the order travelled.
struct StrokeValues {
  std::vector<TactilePoint> tactile;
  std::vector<Section> sections;
  std::vector<CurvePoint> turns;  ///< local extrema that are no tactile points, by displacement
  BottomOut bottomOut;
};

struct GraphValues {
  StrokeValues press;
  std::optional<StrokeValues> release;
  double lowest_N = 0, highest_N = 0;  ///< over both strokes

  const StrokeValues& of(Stroke stroke) const {
    return stroke == Stroke::release && release ? *release : press;
  }
};

/// Any thread.
GraphValues valuesOf(const ForceGraph& graph);

}  // namespace detent::editor
