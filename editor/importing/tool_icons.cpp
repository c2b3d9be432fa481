// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/tool_icons.h"

#include <functional>
#include <QPainter>
#include <QPainterPath>

#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

constexpr double side = 20;  // icons are drawn on a grid of 20 x 20

using Drawing = std::function<void(QPainter&, const QColor&)>;

QPixmap drawn(const Drawing& draw, const QColor& ink, double scale) {
  QPixmap pixmap(static_cast<int>(side * scale), static_cast<int>(side * scale));
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  painter.setPen(QPen(ink, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  draw(painter, ink);
  return pixmap;
}

QIcon iconOf(const Drawing& draw, const QPalette& palette) {
  QIcon icon;
  for (const double scale : {1.0, 2.0, 3.0}) {
    icon.addPixmap(drawn(draw, palette.color(QPalette::Active, QPalette::ButtonText), scale));
    icon.addPixmap(drawn(draw, palette.color(QPalette::Disabled, QPalette::ButtonText), scale),
                   QIcon::Disabled);
  }
  return icon;
}

void drawAdjust(QPainter& p, const QColor& ink) {
  p.drawRect(QRectF(4, 4, 12, 12));
  p.setBrush(ink);
  for (const QPointF& at : {QPointF(4, 4), QPointF(16, 4), QPointF(16, 16), QPointF(4, 16)})
    p.drawRect(QRectF(at - QPointF(1.4, 1.4), QSizeF(2.8, 2.8)));
}

void drawScale(QPainter& p, const QColor&) {
  p.drawPolyline(QPolygonF({{4, 2}, {4, 16}, {18, 16}}));
  for (const double x : {8.0, 12.0, 16.0}) p.drawLine(QPointF(x, 16), QPointF(x, 13.5));
  for (const double y : {4.0, 8.0, 12.0}) p.drawLine(QPointF(4, y), QPointF(6.5, y));
  p.drawLine(QPointF(12, 4), QPointF(12, 9));  // a one
  p.drawLine(QPointF(10.4, 5.2), QPointF(12, 4));
}

void drawFrameIcon(QPainter& p, const QColor& ink) {
  p.setPen(QPen(ink, 1.6, Qt::CustomDashLine));
  QPen dashed(ink, 1.6);
  dashed.setDashPattern({2, 1.6});
  p.setPen(dashed);
  p.drawRect(QRectF(3, 4, 11, 9));
  p.setPen(QPen(ink, 1.6));
  p.drawLine(QPointF(14, 10), QPointF(14, 18));
  p.drawLine(QPointF(10, 14), QPointF(18, 14));
}

void drawPipette(QPainter& p, const QColor& ink, const QColor& drop) {
  p.drawLine(QPointF(5, 15), QPointF(12, 8));
  p.drawLine(QPointF(10, 5.5), QPointF(14.5, 10));
  p.setBrush(ink);
  p.drawEllipse(QPointF(14.6, 5.4), 2.4, 2.4);
  p.setPen(Qt::NoPen);
  p.setBrush(drop);
  p.drawEllipse(QPointF(4.6, 16.2), 2.6, 2.6);
}

// A line through three points.
void drawPen(QPainter& p, const QColor& ink, const QColor& line) {
  QPainterPath course(QPointF(3, 16));
  course.cubicTo(7, 2, 11, 18, 17, 5);
  p.setPen(QPen(line, 2));
  p.drawPath(course);
  p.setPen(Qt::NoPen);
  p.setBrush(ink);
  for (const QPointF at : {QPointF(3, 16), QPointF(9.3, 10.2), QPointF(17, 5)}) p.drawEllipse(at, 2.1, 2.1);
}

void drawMask(QPainter& p, const QColor& ink) {
  p.drawRect(QRectF(3, 5, 14, 10));
  p.setPen(QPen(ink, 1));
  for (const double x : {3.0, 7.0, 11.0}) p.drawLine(QPointF(x, 15), QPointF(x + 6, 5));
}

void drawBrush(QPainter& p, const QColor& ink) {
  p.drawLine(QPointF(17, 3), QPointF(10, 10));
  QPainterPath bristles(QPointF(8.5, 9));
  bristles.quadTo(11.5, 10, 11, 12);
  bristles.quadTo(9, 17, 3, 17);
  bristles.quadTo(5.5, 14, 5.2, 12);
  bristles.closeSubpath();
  p.setBrush(ink);
  p.drawPath(bristles);
}

void drawPan(QPainter& p, const QColor&) {
  p.drawLine(QPointF(10, 2.5), QPointF(10, 17.5));
  p.drawLine(QPointF(2.5, 10), QPointF(17.5, 10));
  for (int turn = 0; turn < 4; ++turn) {
    p.drawPolyline(QPolygonF({{7.8, 4.7}, {10, 2.5}, {12.2, 4.7}}));
    p.translate(10, 10);
    p.rotate(90);
    p.translate(-10, -10);
  }
}

void drawArrowBack(QPainter& p, const QColor&) {
  QPainterPath path(QPointF(4, 8));
  path.lineTo(12, 8);
  path.cubicTo(18, 8, 18, 16, 12, 16);
  path.lineTo(8, 16);
  p.drawPath(path);
  p.drawPolyline(QPolygonF({{7.5, 4.2}, {3.8, 8}, {7.5, 11.8}}));
}

void drawGlass(QPainter& p, bool plus) {
  p.drawEllipse(QPointF(8.5, 8.5), 5.5, 5.5);
  p.drawLine(QPointF(12.6, 12.6), QPointF(17.5, 17.5));
  p.drawLine(QPointF(6, 8.5), QPointF(11, 8.5));
  if (plus) p.drawLine(QPointF(8.5, 6), QPointF(8.5, 11));
}

void drawFit(QPainter& p, bool graph) {
  for (int turn = 0; turn < 4; ++turn) {
    p.drawPolyline(QPolygonF({{2.5, 6.5}, {2.5, 2.5}, {6.5, 2.5}}));
    p.translate(10, 10);
    p.rotate(90);
    p.translate(-10, -10);
  }
  if (graph) {
    p.drawPolyline(QPolygonF({{6, 6}, {6, 14}, {14.5, 14}}));
    p.drawPolyline(QPolygonF({{7.5, 11.5}, {10, 8}, {11.5, 10.5}, {14, 6}}));
  } else {
    p.drawRect(QRectF(7, 5.5, 6, 9));
  }
}

}  // namespace

QIcon toolIcon(ToolKind kind, const QPalette& palette) {
  const GraphColors colors = graphColors(isDark(palette));
  switch (kind) {
    case ToolKind::adjust:
      return iconOf(drawAdjust, palette);
    case ToolKind::scale:
      return iconOf(drawScale, palette);
    case ToolKind::drawFrame:
      return iconOf(drawFrameIcon, palette);
    case ToolKind::pressColor:
      return iconOf([drop = colors.press](QPainter& p, const QColor& ink) { drawPipette(p, ink, drop); },
                    palette);
    case ToolKind::releaseColor:
      return iconOf([drop = colors.release](QPainter& p, const QColor& ink) { drawPipette(p, ink, drop); },
                    palette);
    case ToolKind::drawPress:
      return iconOf([line = colors.press](QPainter& p, const QColor& ink) { drawPen(p, ink, line); },
                    palette);
    case ToolKind::drawRelease:
      return iconOf([line = colors.release](QPainter& p, const QColor& ink) { drawPen(p, ink, line); },
                    palette);
    case ToolKind::maskBox:
      return iconOf(drawMask, palette);
    case ToolKind::maskBrush:
      return iconOf(drawBrush, palette);
    case ToolKind::pan:
      return iconOf(drawPan, palette);
  }
  return {};
}

QIcon viewIcon(ViewIcon kind, const QPalette& palette) {
  switch (kind) {
    case ViewIcon::undo:
      return iconOf(drawArrowBack, palette);
    case ViewIcon::redo:
      return iconOf(
          [](QPainter& p, const QColor& ink) {
            p.translate(side, 0);
            p.scale(-1, 1);
            drawArrowBack(p, ink);
          },
          palette);
    case ViewIcon::fitGraph:
    case ViewIcon::fitPage:
      return iconOf([graph = kind == ViewIcon::fitGraph](QPainter& p, const QColor&) { drawFit(p, graph); },
                    palette);
    case ViewIcon::zoomIn:
    case ViewIcon::zoomOut:
      return iconOf([plus = kind == ViewIcon::zoomIn](QPainter& p, const QColor&) { drawGlass(p, plus); },
                    palette);
  }
  return {};
}

}  // namespace detent::editor
