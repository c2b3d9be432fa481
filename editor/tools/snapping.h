// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Snapping of a dragged point.

#include <optional>
#include <span>

#include "editor/canvas/canvas_feedback.h"
#include "editor/canvas/plot_mapping.h"
#include "editor/document/view_settings.h"
#include "model/stroke_curve.h"

namespace detent::editor {

/// Snap targets. References must outlive the call.
struct SnapSources {
  std::span<const CurvePoint> traced;        ///< traced points of the dragged point's stroke
  const StrokeCurve* otherStroke = nullptr;  ///< null: none
};

/// The nearest traced point, or place on the other stroke, within the settings' reach; else the nearest grid
/// lines, each axis separately; nullopt if nothing is near enough.
std::optional<SnapHit> snapOf(CurvePoint wanted, const PlotMapping& map, const SnapSettings& settings,
                              const SnapSources& sources);

}  // namespace detent::editor
