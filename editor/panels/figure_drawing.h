// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a key figure measures, as a small drawing.

#include <QPainter>
#include <QPixmap>
#include <QRectF>

#include "editor/document/graph_colors.h"
#include "model/key_figures.h"

namespace detent::editor {

/// Both strokes of a tactile switch, and on them, in `mark`, what the figure measures: a height as an arrow up from the
/// travel axis, a way as an arrow below it, a spring rate as a chord, a work as an area. Lines are as fine as the box is
/// small, down to one unit.
void paintKeyFigure(QPainter& painter, const QRectF& box, KeyFigure figure, const GraphColors& colors,
                    const QColor& mark);

/// The same on nothing, sharp at a scale.
QPixmap keyFigurePicture(QSize size, double devicePixelRatio, KeyFigure figure, const GraphColors& colors);

}  // namespace detent::editor
