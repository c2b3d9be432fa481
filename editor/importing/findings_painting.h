// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drawing of findings and corrections on the page.

#include <QPainter>
#include <vector>

#include "editor/document/display_units.h"
#include "editor/document/graph_colors.h"
#include "editor/importing/corrections.h"
#include "editor/importing/drawn_result.h"

namespace detent::editor {

/// Objects painted over the page; references live as long as the call.
struct FindingsPicture {
  const DrawnResult& drawn;
  const Corrections& given;
  std::optional<FrameCorners> corners;
  QTransform pageToWidget;
  DisplayUnits units;  ///< units of the labels: those printed on the page
  bool stale = false;  ///< a newer result is being computed, or failed: curves are drawn paler
};

void paintFindings(QPainter& painter, const FindingsPicture& picture);

/// Middle of the plate that shows a tick's value, widget.
QPointF tickPlate(GraphAxis axis, const FrameCorners& corners, const QTransform& pageToWidget, QPointF tick);

/// Left end of a text beside a mark: of 24 places, first above it or below, the first whose plate covers
/// nothing of `taken`, else the one that covers least. A plate that `shown` would cut off is moved into it.
/// Its plate becomes taken too.
QPointF freePlace(QPointF mark, QSizeF text, bool above, const QRectF& shown, std::vector<QRectF>& taken);

/// A text on a plate, so that it can be read on any page. `at` is the plate's left middle.
void paintPlate(QPainter& painter, QPointF at, const QString& text, const QColor& color);

}  // namespace detent::editor
