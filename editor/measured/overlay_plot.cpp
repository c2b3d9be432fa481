// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/overlay_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "editor/canvas/plot_dress.h"
#include "editor/canvas/unit_ticker.h"
#include "editor/document/message_words.h"

namespace detent::editor {
namespace {

constexpr std::size_t scatterPoints = 201;
constexpr int bandAlpha = 50, longestName = 28;
constexpr double roomAbove = 1.1;

double forceAt(const std::vector<float>& forces_N, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(forces_N.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), forces_N.size() - 2);
  return std::lerp(double{forces_N[i]}, double{forces_N[i + 1]}, at - static_cast<double>(i));
}

}  // namespace

std::vector<ScatterPoint> scatterOf(const std::vector<const importer::FeltShape*>& shapes) {
  if (shapes.size() < 2) return {};
  double common_mm = std::numeric_limits<double>::infinity();
  for (const auto* shape : shapes) common_mm = std::min(common_mm, shape->travel_mm);
  std::vector<ScatterPoint> points;
  const auto n = static_cast<double>(shapes.size());
  for (std::size_t i = 0; i < scatterPoints; ++i) {
    ScatterPoint point{common_mm * static_cast<double>(i) / static_cast<double>(scatterPoints - 1), 0, 0};
    std::vector<double> forces_N;
    for (const auto* shape : shapes)
      forces_N.push_back(forceAt(shape->press_N, point.displacement_mm / shape->travel_mm));
    for (const double force_N : forces_N) point.mean_N += force_N / n;
    for (const double force_N : forces_N)
      point.sd_N += (force_N - point.mean_N) * (force_N - point.mean_N) / (n - 1);
    point.sd_N = std::sqrt(point.sd_N);
    points.push_back(point);
  }
  return points;
}

OverlayPlot::OverlayPlot(QWidget* parent) : QCustomPlot(parent) {
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  putLegendAbove(*this);
  for (QCPAxis* axis : {xAxis, yAxis}) axis->setTicker(QSharedPointer<UnitTicker>::create());
}

void OverlayPlot::show(std::vector<Entry> entries, std::optional<importer::FeltShape> requested,
                       const DisplayUnits& units) {
  entries_ = std::move(entries);
  requested_ = std::move(requested);
  units_ = units;
  redraw();
}

void OverlayPlot::drawShape(const importer::FeltShape& shape, const QPen& pen, const QString& name) {
  const auto add = [&](const std::vector<float>& forces_N, Qt::PenStyle style, bool named) {
    if (forces_N.empty()) return;
    auto* curve = addGraph();
    QVector<double> x, y;
    for (std::size_t i = 0; i < forces_N.size(); ++i) {
      x << units_.lengthFrom(shape.travel_mm * static_cast<double>(i) /
                             static_cast<double>(forces_N.size() - 1));
      y << units_.forceFrom(double{forces_N[i]});
    }
    curve->setData(x, y, true);
    QPen styled = pen;
    styled.setStyle(style);
    curve->setPen(styled);
    curve->setName(name);
    if (!named) curve->removeFromLegend();
  };
  add(shape.press_N, Qt::SolidLine, true);
  add(shape.release_N, Qt::DashLine, false);
}

void OverlayPlot::drawBand(const QColor& color) {
  std::vector<const importer::FeltShape*> shapes;
  for (const Entry& entry : entries_) shapes.push_back(entry.shape);
  const auto scatter = scatterOf(shapes);
  if (scatter.empty()) return;
  QVector<double> x, low, high;
  for (const ScatterPoint& point : scatter) {
    x << units_.lengthFrom(point.displacement_mm);
    low << units_.forceFrom(point.mean_N - point.sd_N);
    high << units_.forceFrom(point.mean_N + point.sd_N);
  }
  QCPGraph* const lower = addGraph();
  QCPGraph* const upper = addGraph();
  lower->setData(x, low, true);
  upper->setData(x, high, true);
  lower->setPen(Qt::NoPen);
  upper->setPen(Qt::NoPen);
  QColor pale = color;
  pale.setAlpha(bandAlpha);
  upper->setBrush(pale);
  upper->setChannelFillGraph(lower);
  lower->removeFromLegend();
  upper->setName(
      tr("press of %n switches, \u00b1 1 standard deviation", nullptr, static_cast<int>(entries_.size())));
}

void OverlayPlot::redraw() {
  clearGraphs();
  const GraphColors colors = dressPlot(*this);
  const bool dark = isDark(palette());
  xAxis->setLabel(tr("Displacement from first contact (%1)").arg(units_.lengthSymbol()));
  yAxis->setLabel(tr("Force (%1)").arg(units_.forceSymbol()));
  drawBand(colors.axis);
  if (requested_) drawShape(*requested_, QPen(colors.text, 3), tr("reference"));
  for (std::size_t i = 0; i < std::min(entries_.size(), mostCurves); ++i)
    drawShape(*entries_[i].shape, QPen(seriesColor(i, dark), 1.5), shortened(entries_[i].name, longestName));
  if (graphCount() > 0) {
    rescaleAxes();
    yAxis->setRange(std::min(0.0, yAxis->range().lower), yAxis->range().upper * roomAbove);
  }
  const bool anything = graphCount() > 0;
  layOutLegend();
  legend->setVisible(anything);
  // hidden without curves, because a legend without entries would leave the axes no space
  axisRect()->setVisible(anything);
  replot(rpQueuedReplot);
}

// Puts names side by side only if all of them fit, because a QCPLegend would cut them off.
void OverlayPlot::layOutLegend() {
  int widest_px = 0;
  for (int i = 0; i < legend->itemCount(); ++i)
    if (const QCPAbstractLegendItem* item = legend->item(i))  // a cell of the last row may be empty
      widest_px = std::max(widest_px, item->minimumOuterSizeHint().width());
  const QMargins margins = legend->margins();
  const int pair_px = margins.left() + 2 * widest_px + legend->columnSpacing() + margins.right();
  legend->setWrap(pair_px <= plotLayout()->rect().width() ? 2 : 1);
  legend->setFillOrder(legend->fillOrder(), true);
}

void OverlayPlot::resizeEvent(QResizeEvent* event) {
  QCustomPlot::resizeEvent(event);  // draws at once, with the previous legend
  layOutLegend();
  replot(rpQueuedReplot);
}

void OverlayPlot::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) redraw();
}

}  // namespace detent::editor
