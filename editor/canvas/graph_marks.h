// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Selectable marks on a force graph and their identities.

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
  slopeBefore,  ///< slope handle of the piece that ends at a knot
  slopeAfter,   ///< slope handle of the piece that starts at a knot
  section,
  operatingPoint,
  resetPoint
};

inline bool isSlope(MarkKind kind) { return kind == MarkKind::slopeBefore || kind == MarkKind::slopeAfter; }
inline bool isContact(MarkKind kind) {
  return kind == MarkKind::operatingPoint || kind == MarkKind::resetPoint;
}

/// Identifies a mark of the active state. Indices as in the model: tactilePoints(), sectionsOf() and knots();
/// turns as in StrokeValues::turns. Operating point: press, index 0; reset point: release, index 0.
struct MarkId {
  MarkKind kind = MarkKind::knot;
  Stroke stroke = Stroke::press;
  std::size_t index = 0;
  friend bool operator==(const MarkId&, const MarkId&) = default;
};

/// A mark and its position.
struct Mark {
  MarkId id;
  CurvePoint at;  ///< of a section: its middle, on the curve
};

/// All points of a state in Tab order: press by displacement, release in the order travelled, operating and
/// reset point. Sections and slope handles are not included.
std::vector<Mark> pointMarks(const ButtonState& state, const GraphValues& values);

/// Current position of a mark; nullopt if the state has no such mark. Slope handles have their knot's
/// position.
std::optional<CurvePoint> placeOf(MarkId id, const ButtonState& state, const GraphValues& values);

/// The two slope handles of a knot on the screen, `length_px` from it; only on sides with a piece that has a
/// slope.
struct SlopeHandles {
  std::optional<QPointF> before_px, after_px;
};
SlopeHandles slopeHandlesOf(const StrokeCurve& curve, std::size_t knot, const PlotMapping& map,
                            double length_px = 46);

/// "Tactile point 1 of the press": for status bar, tool tips and screen readers.
QString nameOf(MarkId id);
/// Name and position: "Tactile point 1 of the press, 1.30 mm, 55.0 cN".
QString describe(const Mark& mark, const DisplayUnits& units);
/// "1.305 mm, 55.02 cN"
QString placeText(CurvePoint at, const DisplayUnits& units);

}  // namespace detent::editor
