// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What tools show over the graph while they work; no part of the button.

#include <optional>
#include <QPointF>
#include <QRectF>
#include <QString>

#include "editor/canvas/graph_marks.h"

namespace detent::editor {

/// What a dragged point clings to at the moment.
enum class SnapKind { grid, tracedPoint, otherStroke };

struct SnapHit {
  CurvePoint at;
  SnapKind kind = SnapKind::grid;
  friend bool operator==(const SnapHit&, const SnapHit&) = default;
};

/// A move that a rule forbids: the graph keeps its last valid shape, and this is shown beside it.
struct RefusedMove {
  CurvePoint wanted;
  QString why;  ///< the Failure's sentence
  friend bool operator==(const RefusedMove&, const RefusedMove&) = default;
};

/// What a click would add here.
struct Proposal {
  CurvePoint at;
  Stroke stroke = Stroke::press;
  std::optional<CurvePoint> to;  ///< of a jump being drawn: where it comes back
  friend bool operator==(const Proposal&, const Proposal&) = default;
};

/// Plain value; the canvas draws what is set.
struct CanvasFeedback {
  std::optional<MarkId> hovered;
  std::optional<SnapHit> snap;
  std::optional<RefusedMove> refused;
  std::optional<Proposal> proposal;
  std::optional<QRectF> band_px;      ///< rectangle being drawn to select what lies in it
  std::optional<CurvePoint> dragged;  ///< where the dragged thing stands; the magnifier looks at it
  friend bool operator==(const CanvasFeedback&, const CanvasFeedback&) = default;
};

}  // namespace detent::editor
