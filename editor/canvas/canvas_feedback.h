// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Temporary drawings of tools over the graph; not part of the button.

#include <optional>
#include <QPointF>
#include <QRectF>
#include <QString>

#include "editor/canvas/graph_marks.h"

namespace detent::editor {

/// Target to which a dragged point currently snaps.
enum class SnapKind { grid, tracedPoint, otherStroke };

struct SnapHit {
  CurvePoint at;
  SnapKind kind = SnapKind::grid;
  friend bool operator==(const SnapHit&, const SnapHit&) = default;
};

/// A move forbidden by a rule: the graph keeps its last valid shape, and this is shown beside it.
struct RefusedMove {
  CurvePoint wanted;
  QString why;  ///< sentence of the Failure
  friend bool operator==(const RefusedMove&, const RefusedMove&) = default;
};

/// Point that a click would add here.
struct Proposal {
  CurvePoint at;
  Stroke stroke = Stroke::press;
  std::optional<CurvePoint> to;  ///< point at which the jump being drawn returns to the curve
  friend bool operator==(const Proposal&, const Proposal&) = default;
};

/// Two places whose distance is shown.
struct Measurement {
  CurvePoint from, to;
  friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// Plain value; the canvas draws the fields that are set.
struct CanvasFeedback {
  std::optional<MarkId> hovered;
  std::optional<SnapHit> snap;
  std::optional<RefusedMove> refused;
  std::optional<Proposal> proposal;
  std::optional<QRectF> band_px;          ///< selection rectangle being drawn
  std::optional<CurvePoint> dragged;      ///< position of the dragged item, shown by the magnifier
  std::optional<CurvePoint> draggedFrom;  ///< its position at the start of the drag
  std::optional<Measurement> measured;
  friend bool operator==(const CanvasFeedback&, const CanvasFeedback&) = default;
};

}  // namespace detent::editor
