// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What on a force graph a hand can take, and by what name it is remembered.

#include <cstddef>
#include <optional>
#include <QString>
#include <vector>

#include "editor/canvas/graph_values.h"
#include "editor/canvas/plot_mapping.h"
#include "editor/document/display_units.h"

namespace detent::editor {

enum class MarkKind {
  tactilePoint,
  turn,  ///< a valley or hump that is not a tactile point
  knot,
  slopeBefore,  ///< handle of the slope of the piece that ends at a knot
  slopeAfter,   ///< handle of the slope of the piece that starts there
  section,
  operatingPoint,
  resetPoint
};

/// Names one mark of the active state. Indices as the model lists them: tactilePoints(), sectionsOf() and
/// knots(); turns as StrokeValues::turns. Operating point: press, index 0; reset point: release, index 0.
struct MarkId {
  MarkKind kind = MarkKind::knot;
  Stroke stroke = Stroke::press;
  std::size_t index = 0;
  friend bool operator==(const MarkId&, const MarkId&) = default;
};

/// A mark where it stands.
struct Mark {
  MarkId id;
  CurvePoint at;  ///< of a section: its middle, on the curve
};

/// All points of a state in the order in which Tab goes through them: press by displacement, release in the
/// order travelled, operating and reset point. Sections and slope handles are not among them.
std::vector<Mark> pointMarks(const ButtonState& state, const GraphValues& values);

/// Where a mark stands now; nullopt if the state has no such mark (any more). Slope handles have their knot's
/// place.
std::optional<CurvePoint> placeOf(MarkId id, const ButtonState& state, const GraphValues& values);

/// The two slope handles of a knot on the screen, `length_px` from it; only on sides that have a curve piece
/// with a slope.
struct SlopeHandles {
  std::optional<QPointF> before_px, after_px;
};
SlopeHandles slopeHandlesOf(const StrokeCurve& curve, std::size_t knot, const PlotMapping& map,
                            double length_px = 46);

/// "Tactile point 1 of the press": for status bar, tool tips and screen readers.
QString nameOf(MarkId id);
/// The name with where it stands: "Tactile point 1 of the press, 1.30 mm, 55.0 cN".
QString describe(const Mark& mark, const DisplayUnits& units);
/// "1.305 mm, 55.02 cN"
QString placeText(CurvePoint at, const DisplayUnits& units);

}  // namespace detent::editor
