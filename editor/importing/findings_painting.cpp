// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/findings_painting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <vector>

#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

// Pages are light in both themes, so the colours for a light background are always used.
const GraphColors& pageColors() {
  static const GraphColors colors = graphColors(false);
  return colors;
}

QString tr(const char* text) { return QCoreApplication::translate("detent::editor::PageView", text); }

QString shortNumber(double value) { return numberText(value, 4); }

QPointF toWidget(const FindingsPicture& picture, importer::Point p) {
  return picture.pageToWidget.map(QPointF(p.x, p.y));
}

/// Background plate of a text drawn with its left end at `at`.
QRectF plateAt(QPointF at, QSizeF text) {
  return {at.x() - 3, at.y() - 0.5 * text.height() - 1, text.width() + 6, text.height() + 2};
}

/// Draws a white line under a coloured one, so that it is visible on dark lines and on paper.
void haloed(QPainter& painter, const QPolygonF& line, const QPen& pen) {
  QPen halo(QColor(255, 255, 255, 170), pen.widthF() + 2);
  painter.setPen(halo);
  painter.drawPolyline(line);
  painter.setPen(pen);
  painter.drawPolyline(line);
}

void paintMasks(QPainter& painter, const FindingsPicture& picture) {
  painter.setPen(QPen(pageColors().refused, 1));
  QBrush hatch(pageColors().refused, Qt::BDiagPattern);
  painter.setBrush(hatch);
  for (const auto& mask : picture.given.masks)
    painter.drawRect(
        picture.pageToWidget.mapRect(QRectF(QPointF(mask.x0, mask.y0), QPointF(mask.x1, mask.y1))));
}

void paintFrame(QPainter& painter, const FindingsPicture& picture) {
  QPolygonF outline;
  for (const auto& corner : *picture.corners) outline << toWidget(picture, corner);
  outline << outline.front();
  painter.setBrush(Qt::NoBrush);
  haloed(painter, outline, QPen(pageColors().operatingPoint, picture.given.frame ? 2 : 1.2));
}

/// Draws the lines on which the values of the ticks lie, according to the corners. If they deviate from the
/// printed grid, a corner or a tick is wrong.
void paintImpliedGrid(QPainter& painter, const FindingsPicture& picture) {
  const FrameCorners& c = *picture.corners;
  QTransform ofFrame;
  const QPolygonF quad(
      {toWidget(picture, c[0]), toWidget(picture, c[1]), toWidget(picture, c[2]), toWidget(picture, c[3])});
  if (!QTransform::squareToQuad(quad, ofFrame)) return;
  painter.setPen(QPen(QColor(138, 58, 134, 120), 1));
  const auto line = [&](GraphAxis axis, importer::Point at) {
    const auto share = shareAlong(axis, c, at);
    if (!share || *share < 0 || *share > 1) return;
    if (axis == GraphAxis::x)
      painter.drawLine(ofFrame.map(QPointF(*share, 0)), ofFrame.map(QPointF(*share, 1)));
    else
      painter.drawLine(ofFrame.map(QPointF(0, 1 - *share)), ofFrame.map(QPointF(1, 1 - *share)));
  };
  for (const GraphAxis axis : {GraphAxis::x, GraphAxis::y}) {
    for (const DrawnTick& tick : axis == GraphAxis::x ? picture.drawn.xTicks : picture.drawn.yTicks)
      if (tick.used) line(axis, tick.at);
    for (const AxisTick& tick : picture.given.axis(axis).ticks) line(axis, tick.at);
  }
}

/// Unit vector in the widget that points from the axis away from the plot.
QPointF outwards(GraphAxis axis, const FrameCorners& c, const QTransform& pageToWidget) {
  const importer::Point inside = axis == GraphAxis::x ? c[0] : c[2];
  const QPointF d = pageToWidget.map(QPointF(c[3].x, c[3].y)) - pageToWidget.map(QPointF(inside.x, inside.y));
  const double length = std::hypot(d.x(), d.y());
  return length > 0 ? d / length : QPointF(0, 1);
}

void paintTick(QPainter& painter, GraphAxis axis, const FindingsPicture& picture, QPointF at,
               const QString& text, const QColor& color, bool given, std::vector<QRectF>& taken) {
  const QPointF out = outwards(axis, *picture.corners, picture.pageToWidget);
  painter.setPen(QPen(QColor(255, 255, 255, 190), given ? 5 : 3.5));
  painter.drawLine(at - 6 * out, at + 6 * out);
  painter.setPen(QPen(color, given ? 2.6 : 1.4));
  painter.drawLine(at - 6 * out, at + 6 * out);
  const QSizeF size = QFontMetricsF(painter.font()).size(0, text);
  const QPointF middle = tickPlate(axis, *picture.corners, picture.pageToWidget, at);
  const QPointF left = middle - QPointF(0.5 * size.width(), 0);
  paintPlate(painter, left, text, color);
  taken.push_back(plateAt(left, size));
}

void paintTicks(QPainter& painter, GraphAxis axis, const FindingsPicture& picture,
                std::vector<QRectF>& taken) {
  const auto& found = axis == GraphAxis::x ? picture.drawn.xTicks : picture.drawn.yTicks;
  std::vector<AxisTick> given = picture.given.axis(axis).ticks;
  if (const auto& min = picture.given.axis(axis).min)
    given.push_back({placeAlong(axis, *picture.corners, 0), *min});
  if (const auto& max = picture.given.axis(axis).max)
    given.push_back({placeAlong(axis, *picture.corners, 1), *max});
  const QColor used("#8a3a86"), unused("#8d949d");
  for (const DrawnTick& tick : found) {
    const bool isGiven = std::any_of(given.begin(), given.end(), [&](const AxisTick& t) {
      const QPointF d = toWidget(picture, t.at) - toWidget(picture, tick.at);
      return std::hypot(d.x(), d.y()) < 3;
    });
    if (isGiven) continue;
    paintTick(painter, axis, picture, toWidget(picture, tick.at),
              tick.used ? shortNumber(tick.value) : QStringLiteral("(%1)").arg(shortNumber(tick.value)),
              tick.used ? used : unused, false, taken);
  }
  for (const AxisTick& tick : given)
    paintTick(painter, axis, picture, toWidget(picture, tick.at), shortNumber(tick.value),
              pageColors().release, true, taken);
}

void paintStroke(QPainter& painter, const FindingsPicture& picture, const DrawnStroke& stroke,
                 const QColor& color, bool dashed) {
  painter.setBrush(Qt::NoBrush);
  const QPolygonF traced = picture.pageToWidget.map(stroke.traced),
                  fit = picture.pageToWidget.map(stroke.fit);
  painter.setPen(QPen(QColor(60, 60, 60, 150), 1));
  painter.drawPolyline(traced);
  QColor shown = color;
  if (picture.stale) shown.setAlpha(110);
  QPen pen(shown, 2);
  if (dashed) pen.setDashPattern({6, 3});
  haloed(painter, fit, pen);
}

QString markLabel(const DrawnMark& mark) {
  switch (mark.kind) {
    case DrawnMark::Kind::tactile:
      return {};
    case DrawnMark::Kind::operating:
      return tr("operating point") + ' ';
    case DrawnMark::Kind::reset:
      return tr("reset point") + ' ';
  }
  return {};
}

/// The visible part of the page, in the painter's coordinates.
QRectF shownPart(const QPainter& painter) {
  if (painter.hasClipping()) return painter.clipBoundingRect();
  return painter.worldTransform().inverted().mapRect(QRectF(painter.window()));
}

/// Offset that moves a plate into the visible part.
QPointF wayInto(const QRectF& shown, const QRectF& plate) {
  const auto way = [](double lower, double upper, double from, double to) {
    return std::max(std::min(0.0, upper - to), lower - from);
  };
  return {way(shown.left(), shown.right(), plate.left(), plate.right()),
          way(shown.top(), shown.bottom(), plate.top(), plate.bottom())};
}

void paintMark(QPainter& painter, const FindingsPicture& picture, const DrawnMark& mark,
               std::vector<QRectF>& taken) {
  const QPointF at = picture.pageToWidget.map(mark.at);
  const QColor color = mark.kind == DrawnMark::Kind::tactile
                           ? (mark.stroke == Stroke::press ? pageColors().press : pageColors().release)
                       : mark.kind == DrawnMark::Kind::operating ? pageColors().operatingPoint
                                                                 : pageColors().resetPoint;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::white, 4));
  painter.drawEllipse(at, 6, 6);
  painter.setPen(QPen(color, 2));
  painter.drawEllipse(at, 6, 6);
  const DisplayUnits& u = picture.units;
  const QString text =
      markLabel(mark) + tr("%1 %2, %3 %4")
                            .arg(numberText(u.lengthFrom(mark.value.displacement_mm), 3), u.lengthSymbol(),
                                 numberText(u.forceFrom(mark.value.force_N), 3), u.forceSymbol());
  const QSizeF size = QFontMetricsF(painter.font()).size(0, text);
  paintPlate(painter, freePlace(at, size, mark.stroke == Stroke::press, shownPart(painter), taken), text,
             color);
}

double area(const QRectF& box) { return box.width() * box.height(); }

}  // namespace

QPointF freePlace(QPointF mark, QSizeF size, bool above, const QRectF& shown, std::vector<QRectF>& taken) {
  constexpr double rows[] = {1, -1, 2.2, -2.2, 3.4, -3.4, 4.6, -4.6};
  const double up = above ? -14 : 16;
  QPointF chosen;
  double least = std::numeric_limits<double>::infinity();
  for (const double row : rows)
    for (const double side : {12.0, -12 - size.width(), -0.5 * size.width()}) {
      QPointF at = mark + QPointF(side, row * up);
      at += wayInto(shown, plateAt(at, size));
      const QRectF plate = plateAt(at, size);
      double hidden = 0;
      for (const QRectF& other : taken) hidden += area(other & plate);
      if (hidden >= least) continue;
      chosen = at;
      least = hidden;
    }
  taken.push_back(plateAt(chosen, size));
  return chosen;
}

QPointF tickPlate(GraphAxis axis, const FrameCorners& corners, const QTransform& pageToWidget, QPointF tick) {
  // Inside the frame, because the page's own labels are outside.
  return tick - outwards(axis, corners, pageToWidget) * (axis == GraphAxis::x ? 16 : 24);
}

void paintPlate(QPainter& painter, QPointF at, const QString& text, const QColor& color) {
  const QFontMetricsF metrics(painter.font());
  const QSizeF size = metrics.size(0, text);
  const QRectF plate = plateAt(at, size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(255, 255, 255, 225));
  painter.drawRoundedRect(plate, 3, 3);
  painter.setPen(color);
  painter.drawText(plate, Qt::AlignCenter, text);
}

void paintFindings(QPainter& painter, const FindingsPicture& picture) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPointSizeF(std::max(7.0, 0.85 * font.pointSizeF()));
  painter.setFont(font);
  std::vector<QRectF> taken;
  const auto keepClear = [&](QPointF at) { taken.emplace_back(at - QPointF(7, 7), QSizeF(14, 14)); };
  paintMasks(painter, picture);
  painter.setPen(QPen(pageColors().refused, 1.5));
  for (const QPolygonF& trace : picture.drawn.traces) painter.drawPolyline(picture.pageToWidget.map(trace));
  if (picture.drawn.press) paintStroke(painter, picture, *picture.drawn.press, pageColors().press, false);
  if (picture.drawn.release)
    paintStroke(painter, picture, *picture.drawn.release, pageColors().release, true);
  if (picture.corners) {
    if (picture.given.frame) paintImpliedGrid(painter, picture);
    paintFrame(painter, picture);
    paintTicks(painter, GraphAxis::x, picture, taken);
    paintTicks(painter, GraphAxis::y, picture, taken);
    for (const importer::Point& corner : *picture.corners) keepClear(toWidget(picture, corner));
  }
  for (const DrawnMark& mark : picture.drawn.marks) keepClear(picture.pageToWidget.map(mark.at));
  for (const DrawnMark& mark : picture.drawn.marks) paintMark(painter, picture, mark, taken);
  painter.restore();
}

}  // namespace detent::editor
