// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a force graph looks: pure drawing of values, the same for screen, magnifier, pictures and SVG.

#include <QPainter>
#include <span>
#include <vector>

#include "editor/canvas/canvas_feedback.h"
#include "editor/canvas/graph_values.h"
#include "editor/canvas/plot_mapping.h"
#include "editor/document/display_units.h"
#include "editor/document/finger_position.h"
#include "editor/document/graph_colors.h"
#include "editor/quantity/reading_error.h"
#include "model/annotations.h"
#include "model/unit_spread.h"

namespace detent::editor {

/// Everything a picture of the graph shows. References must outlive the call.
struct GraphScene {
  const ButtonState& state;
  const GraphValues& values;
  const GraphColors& colors;
  const DisplayUnits& units;
  const CanvasFeedback& feedback;
  std::span<const MarkId> selection;  ///< the last one has handles
  std::optional<FingerPosition> finger;
  const ButtonState* otherState = nullptr;                 ///< of a self-locking button: drawn as a ghost
  std::span<const CurvePoint> tracedPress, tracedRelease;  ///< residuals are drawn to these; empty: none
  bool handlesShown = true;                  ///< knots and handles; pictures for others go without
  std::optional<ReadingError> readingError;  ///< of a graph read off a page: decides the digits of its forces
  std::span<const Note> notes = {};          ///< remarks; of this state alone they are drawn
  std::span<const PinnedPoint> pinned = {};  ///< drawn with the handles
  std::size_t stateIndex = 0;                ///< of this state among the button's
  const ButtonState* preview = nullptr;      ///< what the state would be: drawn dashed over it
  const StateSpread* spread =
      nullptr;  ///< of the units the state is the mean of: a band of one standard deviation
};

/// Sections, wall, curves, points, handles and feedback, clipped to the map.
void paintGraph(QPainter& painter, const PlotMapping& map, const GraphScene& scene);

/// Shading and curves alone: for the magnifier and small pictures.
void paintCurves(QPainter& painter, const PlotMapping& map, const GraphScene& scene);

/// Why a move is refused, at the top of the plot where nothing hides it.
void paintRefusalReason(QPainter& painter, const PlotMapping& map, const GraphScene& scene);

/// A short text in a box of the background's colour near a point, kept inside `bounds_px`.
void paintTag(QPainter& painter, QPointF at_px, const QString& text, const QColor& ink, const QColor& ground,
              const QRectF& bounds_px);

/// "100 mm/s".
QString speedText(double speed_mm_per_s);

/// Residuals are drawn this many times as long as they are; long ones less, down to their own length.
inline constexpr double residualMagnification = 10;

}  // namespace detent::editor
