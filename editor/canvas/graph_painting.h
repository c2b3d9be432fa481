// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drawing of a force graph from values, shared by screen, magnifier, pictures and SVG.

#include <QPainter>
#include <span>
#include <vector>

#include "editor/canvas/canvas_feedback.h"
#include "editor/canvas/graph_marks.h"
#include "editor/canvas/graph_values.h"
#include "editor/canvas/plot_mapping.h"
#include "editor/document/display_units.h"
#include "editor/document/finger_position.h"
#include "editor/document/graph_colors.h"
#include "editor/quantity/reading_error.h"
#include "model/annotations.h"
#include "model/unit_spread.h"

namespace detent::editor {

/// A label with its mark: a drag of the label moves the mark.
struct Flag {
  QRectF box_px;
  MarkId mark;
};

/// Curves of another button behind those that are edited.
struct Reference {
  ButtonState state;
  QString name;
};

/// Contents of a graph picture. References must outlive the call.
struct GraphScene {
  const ButtonState& state;
  const GraphValues& values;
  const GraphColors& colors;
  const DisplayUnits& units;
  const CanvasFeedback& feedback;
  std::span<const MarkId> selection;  ///< the last one has handles
  std::optional<FingerPosition> finger;
  const ButtonState* otherState = nullptr;  ///< the other state of a self-locking button, drawn faintly
  /// traced points, to which residuals are drawn; empty: none
  std::span<const CurvePoint> tracedPress, tracedRelease;
  bool handlesShown = true;  ///< knots and handles; off in exported pictures
  /// error of an imported graph, which decides how many digits of its values are shown
  std::optional<ReadingError> readingError;
  std::span<const Note> notes = {};          ///< remarks; only those of this state are drawn
  std::span<const PinnedPoint> pinned = {};  ///< drawn with the handles
  std::size_t stateIndex = 0;                ///< index of this state in the button
  const ButtonState* preview = nullptr;      ///< possible new state, drawn dashed
  const ButtonState* before = nullptr;       ///< state before the running drag, drawn pale
  const Reference* reference = nullptr;      ///< state of another button, drawn behind the curves
  std::vector<Flag>* flags = nullptr;   ///< receives the labels that were drawn; null: they are not needed
  const StateSpread* spread = nullptr;  ///< spread of the averaged units: a band of one standard deviation
};

/// Sections, end line, curves, points, handles and feedback, clipped to the map.
void paintGraph(QPainter& painter, const PlotMapping& map, const GraphScene& scene);

/// Paints shading and curves alone, for the magnifier and small pictures.
void paintCurves(QPainter& painter, const PlotMapping& map, const GraphScene& scene);

/// Reason of a refused move, at the top of the plot where nothing hides it.
void paintRefusalReason(QPainter& painter, const PlotMapping& map, const GraphScene& scene);

/// A short text near a point on a box of the background colour, kept inside `bounds_px`.
void paintTag(QPainter& painter, QPointF at_px, const QString& text, const QColor& tagColor,
              const QColor& background, const QRectF& bounds_px);

/// "100 mm/s".
QString speedText(double speed_mm_per_s);

/// Residuals are enlarged by this factor. Long residuals are enlarged less, but never shortened.
inline constexpr double residualMagnification = 10;

}  // namespace detent::editor
