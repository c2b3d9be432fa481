// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Small drawings that show what a key figure measures.

#include <QPainter>
#include <QPixmap>
#include <QRectF>

#include "editor/document/graph_colors.h"
#include "model/key_figures.h"

namespace detent::editor {

/// Draws both strokes of a tactile switch and, in `mark`, the figure: a force as an arrow up from the travel
/// axis, a travel as an arrow below it, a spring rate as a chord, a work as an area. Lines scale with the
/// box, down to one unit.
void paintKeyFigure(QPainter& painter, const QRectF& box, KeyFigure figure, const GraphColors& colors,
                    const QColor& mark);

/// The same on a transparent background, sharp at a scale.
QPixmap keyFigurePicture(QSize size, double devicePixelRatio, KeyFigure figure, const GraphColors& colors);

}  // namespace detent::editor
