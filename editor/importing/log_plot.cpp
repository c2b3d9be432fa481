// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/log_plot.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

#include "editor/document/graph_colors.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

/// 1, 2 or 5 times a power of ten, about a fifth of the span.
double niceStep(double span) {
  const double rough = span / 5, power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}

struct Scale {
  QRectF area;
  double xMax = 1, yMin = 0, yMax = 1;
  QPointF at(double x, double y) const {
    return {area.left() + x / xMax * area.width(),
            area.bottom() - (y - yMin) / (yMax - yMin) * area.height()};
  }
};

QPolygonF fitLine(const StrokeCurve& curve, const DisplayUnits& units, const Scale& scale) {
  constexpr int samples = 400;
  QPolygonF line;
  for (int i = 0; i <= samples; ++i) {
    const double at_mm = curve.start_mm() + curve.travel_mm() * i / samples;
    line << scale.at(units.lengthFrom(at_mm), units.forceFrom(curve.force_N(at_mm)));
  }
  return line;
}

void drawPoints(QPainter& painter, const importer::StrokePoints& points, const DisplayUnits& units,
                const Scale& scale, const QColor& color) {
  constexpr std::size_t mostPoints = 4000;  // more than the plot has pixels
  const std::size_t step = std::max<std::size_t>(1, points.points.size() / mostPoints);
  painter.setPen(QPen(color, 2.5, Qt::SolidLine, Qt::RoundCap));
  for (std::size_t i = 0; i < points.points.size(); i += step)
    painter.drawPoint(scale.at(units.lengthFrom(points.points[i].displacement_mm),
                               units.forceFrom(points.points[i].force_N)));
}

}  // namespace

LogPlot::LogPlot(ImportState& state, ViewSettings& settings, QWidget* parent)
    : QWidget(parent), state_(state), settings_(settings) {
  setAccessibleName(tr("Measured points and fit"));
  connect(&state_, &ImportState::resultChanged, this, qOverload<>(&QWidget::update));
  connect(&settings_, &ViewSettings::changed, this, qOverload<>(&QWidget::update));
}

void LogPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const GraphColors colors = graphColors(isDark(palette()));
  painter.fillRect(rect(), colors.background);
  const ImportGraph* graph = state_.current();
  if (!graph || !graph->good) {
    painter.setPen(colors.text);
    painter.drawText(rect(), Qt::AlignCenter,
                     state_.working() ? tr("Reading the log …") : tr("No curve could be read from this log"));
    return;
  }
  const importer::ImportReport& report = *graph->good->report;
  const DisplayUnits& units = settings_.units();
  const ForceGraph& force = report.button.states().front().graph;
  const auto [low_N, high_N] = force.press().forceRange_N();
  Scale scale;
  scale.area = QRectF(rect()).adjusted(64, 24, -24, -48);
  scale.xMax = 1.04 * units.lengthFrom(force.travel_mm());
  scale.yMin = std::min(0.0, units.forceFrom(low_N));
  scale.yMax = 1.06 * units.forceFrom(high_N);
  if (scale.xMax <= 0 || scale.yMax <= scale.yMin) return;
  for (double x = 0, step = niceStep(scale.xMax); x <= scale.xMax; x += step) {
    painter.setPen(QPen(colors.grid, 1));
    painter.drawLine(scale.at(x, scale.yMin), scale.at(x, scale.yMax));
    painter.setPen(colors.text);
    painter.drawText(QRectF(scale.at(x, scale.yMin) + QPointF(-40, 4), QSizeF(80, 18)), Qt::AlignCenter,
                     numberText(x, 3));
  }
  for (double step = niceStep(scale.yMax - scale.yMin), y = std::ceil(scale.yMin / step) * step;
       y <= scale.yMax; y += step) {
    painter.setPen(QPen(colors.grid, 1));
    painter.drawLine(scale.at(0, y), scale.at(scale.xMax, y));
    painter.setPen(colors.text);
    painter.drawText(QRectF(scale.at(0, y) + QPointF(-60, -9), QSizeF(54, 18)),
                     Qt::AlignRight | Qt::AlignVCenter, numberText(y, 3));
  }
  painter.setPen(QPen(colors.axis, 1.5));
  painter.drawRect(scale.area);
  painter.setPen(colors.text);
  painter.drawText(QRectF(scale.area.left(), scale.area.bottom() + 24, scale.area.width(), 20),
                   Qt::AlignCenter, tr("Displacement [%1]").arg(units.lengthSymbol()));
  painter.drawText(QRectF(4, 2, 200, 20), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("Force [%1]").arg(units.forceSymbol()));
  drawPoints(painter, report.strokes.press, units, scale, colors.tracedPoint);
  if (report.strokes.release) drawPoints(painter, *report.strokes.release, units, scale, colors.tracedPoint);
  painter.setPen(QPen(colors.press, 2));
  painter.drawPolyline(fitLine(force.press(), units, scale));
  if (force.release()) {
    painter.setPen(QPen(colors.release, 2, Qt::DashLine));
    painter.drawPolyline(fitLine(*force.release(), units, scale));
  }
}

}  // namespace detent::editor
