// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How findings and corrections look on the page.

#include <QPainter>

#include "editor/document/display_units.h"
#include "editor/document/graph_colors.h"
#include "editor/importing/corrections.h"
#include "editor/importing/drawn_result.h"

namespace detent::editor {

/// What is painted over the page; references live as long as the call.
struct FindingsPicture {
  const DrawnResult& drawn;
  const Corrections& given;
  std::optional<FrameCorners> corners;
  QTransform pageToWidget;
  DisplayUnits units;
  bool stale = false;  ///< a newer result is being computed, or failed: curves are drawn paler
};

void paintFindings(QPainter& painter, const FindingsPicture& picture);

/// Middle of the plate that shows a tick's value, widget.
QPointF tickPlate(GraphAxis axis, const FrameCorners& corners, const QTransform& pageToWidget, QPointF tick);

/// A text on a plate, so that it can be read on any page. `at` is the plate's left middle.
void paintPlate(QPainter& painter, QPointF at, const QString& text, const QColor& ink);

}  // namespace detent::editor
