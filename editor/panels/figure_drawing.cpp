// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/figure_drawing.h"

#include <algorithm>
#include <cmath>
#include <QPainterPath>

#include "model/metrics.h"
#include "model/templates.h"

namespace detent::editor {
namespace {

// A switch on which all figures differ.
const ButtonState& drawnSwitch() {
  static const ButtonState state = [] {
    const auto press = StrokeCurve::throughPoints({{0, 0.14}, {1, 0.62}, {1.7, 0.3}, {2.7, 0.5}, {3, 1}});
    const auto release =
        StrokeCurve::throughPoints({{0, 0.06}, {0.7, 0.42}, {1.2, 0.14}, {2.75, 0.38}, {3, 0.94}});
    return ButtonState{"", *ForceGraph::fromCurves(*press, *release), 1.35, 0.95, {}};
  }();
  return state;
}

class Drawing {
 public:
  Drawing(QPainter& painter, const QRectF& box, const GraphColors& colors, const QColor& mark)
      : painter_(painter),
        colors_(colors),
        mark_(mark),
        line_(std::max(1.0, box.height() / 70)),
        plot_(box.adjusted(3 * line_, 3 * line_, -3 * line_, -std::max(5 * line_, 0.2 * box.height()))) {}

  void paint(KeyFigure figure) {
    paintArea(figure);
    axes();
    curve(graph().curve(Stroke::release), colors_.release, Qt::DashLine);
    curve(graph().press(), colors_.press, Qt::SolidLine);
    measure(figure);
  }

 private:
  static const ForceGraph& graph() { return drawnSwitch().graph; }
  static double end_mm() { return graph().travel_mm(); }

  QPointF at(double mm, double N) const {
    return {plot_.left() + plot_.width() * mm / end_mm(), plot_.bottom() - plot_.height() * N / 1.05};
  }
  QPointF onPress(double mm) const { return at(mm, graph().press().force_N(mm)); }

  QPainterPath pathOf(const StrokeCurve& stroke) const {
    QPainterPath path(at(0, stroke.force_N(0)));
    for (int i = 1; i <= 120; ++i) path.lineTo(at(end_mm() * i / 120, stroke.force_N(end_mm() * i / 120)));
    return path;
  }
  void curve(const StrokeCurve& stroke, const QColor& color, Qt::PenStyle style) {
    painter_.setPen(QPen(color, 1.3 * line_, style));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPath(pathOf(stroke));
  }
  void axes() {
    painter_.setPen(QPen(colors_.axis, line_));
    painter_.drawLine(plot_.topLeft(), plot_.bottomLeft());
    painter_.drawLine(plot_.bottomLeft(), plot_.bottomRight());
  }

  void paintArea(KeyFigure figure) {
    if (figure != KeyFigure::pressWork && figure != KeyFigure::hysteresis) return;
    QPainterPath area = pathOf(graph().press());
    if (figure == KeyFigure::hysteresis) {
      area.connectPath(pathOf(*graph().release()).toReversed());
    } else {
      area.lineTo(plot_.bottomRight());
      area.lineTo(plot_.bottomLeft());
    }
    area.closeSubpath();
    QColor fill = mark_;
    fill.setAlphaF(0.4F);
    painter_.fillPath(area, fill);
  }

  void head(QPointF tip, QPointF from) {
    const QPointF way = tip - from;
    const double length = std::hypot(way.x(), way.y());
    if (length <= 0) return;
    const QPointF along = way / length * std::min(4 * line_, 0.5 * length);
    const QPointF across(-0.5 * along.y(), 0.5 * along.x());
    const QPolygonF triangle{QList<QPointF>{tip, tip - along + across, tip - along - across}};
    painter_.setBrush(mark_);
    painter_.drawPolygon(triangle);
  }
  void arrow(QPointF from, QPointF to) {
    painter_.setPen(QPen(mark_, 1.4 * line_));
    painter_.drawLine(from, to);
    head(to, from);
    head(from, to);
  }
  void thin(QPointF from, QPointF to) {
    painter_.setPen(QPen(mark_, 0.7 * line_, Qt::DotLine));
    painter_.drawLine(from, to);
  }
  void dot(QPointF place) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(mark_);
    painter_.drawEllipse(place, 2.2 * line_, 2.2 * line_);
  }
  // Draws a force: an arrow up from the travel axis.
  void height(double mm, double N) {
    arrow(at(mm, 0), at(mm, N));
    dot(at(mm, N));
  }
  // Draws a travel: an arrow below the travel axis, with thin lines up to the curve.
  void way(double from_mm, double to_mm, double from_N = 0, double to_N = 0) {
    const double below = 4 * line_;
    const QPointF down(0, below);
    thin(at(from_mm, from_N), at(from_mm, 0) + down);
    thin(at(to_mm, to_N), at(to_mm, 0) + down);
    arrow(at(from_mm, 0) + down, at(to_mm, 0) + down);
  }
  void wayOnPress(double from_mm, double to_mm) {
    way(from_mm, to_mm, from_mm > 0 ? graph().press().force_N(from_mm) : 0, graph().press().force_N(to_mm));
    dot(onPress(to_mm));
  }
  void chord(QPointF from, QPointF to) {
    painter_.setPen(QPen(mark_, 1.8 * line_));
    painter_.drawLine(from, to);
    dot(from);
    dot(to);
  }

  void measure(KeyFigure figure) {
    static const KeyFigures figures = keyFiguresOf(drawnSwitch());
    const auto of = [](KeyFigure wanted) { return figures[wanted].value_or(0); };
    using enum KeyFigure;
    const double peak = of(peakTravel), valley = of(valleyTravel), bottomOut = of(bottomOutTravel);
    const double operating = of(preTravel), reset = of(resetTravel);
    const double reset_N = of(resetForce);
    switch (figure) {
      case initialForce:
        return height(0, of(initialForce));
      case preTravel:
        return wayOnPress(0, operating);
      case operatingForce:
        return height(operating, of(operatingForce));
      case peakForce:
        return height(peak, of(peakForce));
      case peakTravel:
        return wayOnPress(0, peak);
      case valleyForce:
        return height(valley, of(valleyForce));
      case valleyTravel:
        return wayOnPress(0, valley);
      case snapRatio:
        thin(at(peak, 0), at(peak, of(peakForce)));
        [[fallthrough]];
      case drop:
        thin(at(peak, of(peakForce)), at(valley, of(peakForce)));
        return arrow(at(valley, of(peakForce)), at(valley, of(valleyForce)));
      case slopeToPeak:
        return chord(onPress(0), onPress(peak));
      case slopeOfDrop:
        return chord(onPress(peak), onPress(valley));
      case slopeToBottomOut:
        return chord(onPress(valley), onPress(bottomOut));
      case resetTravel:
        way(0, reset, 0, reset_N);
        return dot(at(reset, reset_N));
      case resetForce:
        return height(reset, reset_N);
      case differentialTravel:
        way(reset, operating, reset_N, of(operatingForce));
        dot(at(reset, reset_N));
        return dot(onPress(operating));
      case overTravel:
        way(operating, end_mm(), of(operatingForce), of(endForce));
        return dot(onPress(operating));
      case bottomOutForce:
        return height(bottomOut, of(bottomOutForce));
      case bottomOutTravel:
        return wayOnPress(0, bottomOut);
      case totalTravel:
        return wayOnPress(0, end_mm());
      case endForce:
        return height(end_mm(), of(endForce));
      case pressWork:
      case hysteresis:
        return;
    }
  }

  QPainter& painter_;
  const GraphColors& colors_;
  QColor mark_;
  double line_;
  QRectF plot_;
};

}  // namespace

void paintKeyFigure(QPainter& painter, const QRectF& box, KeyFigure figure, const GraphColors& colors,
                    const QColor& mark) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  Drawing(painter, box, colors, mark).paint(figure);
  painter.restore();
}

QPixmap keyFigurePicture(QSize size, double devicePixelRatio, KeyFigure figure, const GraphColors& colors) {
  QPixmap picture(size * devicePixelRatio);
  picture.setDevicePixelRatio(devicePixelRatio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  paintKeyFigure(painter, QRectF(QPointF(), size), figure, colors, colors.refused);
  return picture;
}

}  // namespace detent::editor
