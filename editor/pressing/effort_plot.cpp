// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/pressing/effort_plot.h"

#include "editor/canvas/plot_dress.h"
#include "editor/canvas/unit_ticker.h"
#include "editor/pressing/press_words.h"

namespace detent::editor {

namespace {

using playback::PressFigure;

constexpr double dotSize_px = 9, margin = 1.15;
constexpr int namesInLine = 3;
constexpr double leastMisses = 1;  // per 1,000, of the axis: below, nobody minds

}  // namespace

EffortPlot::EffortPlot(QWidget* parent) : QCustomPlot(parent) {
  putLegendAbove(*this);
  legend->setWrap(namesInLine);
  for (QCPAxis* axis : {xAxis, yAxis}) axis->setTicker(QSharedPointer<UnitTicker>::create());
  redraw();
}

void EffortPlot::setForecasts(const std::vector<std::shared_ptr<const playback::PressForecast>>& forecasts,
                              const std::vector<QString>& names, const DisplayUnits& units) {
  forecasts_ = forecasts;
  names_ = names;
  units_ = units;
  redraw();
}

void EffortPlot::redraw() {
  clearPlottables();
  dressPlot(*this);
  const PressTerm effort = termOf(PressFigure::peakForce, units_),
                  misses = termOf(PressFigure::misses, units_);
  xAxis->setLabel(QStringLiteral("%1 (%2)").arg(effort.name, effort.unit));
  yAxis->setLabel(tr("Misses per 1,000"));
  const bool dark = isDark(palette());
  double most = 0, mostMisses = leastMisses;
  for (std::size_t i = 0; i < forecasts_.size(); ++i) {
    const playback::PressForecast& forecast = *forecasts_[i];
    if (forecast[PressFigure::peakForce].empty() || forecast[PressFigure::misses].empty()) continue;
    const playback::Band x = playback::bandOf(forecast[PressFigure::peakForce]);
    const playback::Band y = playback::bandOf(forecast[PressFigure::misses]);
    QCPGraph* dot = addGraph();
    dot->setLineStyle(QCPGraph::lsNone);
    dot->setName(names_[i]);
    const QColor color = seriesColor(i, dark);
    dot->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(color), QBrush(color), dotSize_px));
    dot->addData(x.median * effort.factor, y.median * misses.factor);
    for (const auto& [type, band, factor] : {std::tuple(QCPErrorBars::etKeyError, x, effort.factor),
                                             std::tuple(QCPErrorBars::etValueError, y, misses.factor)}) {
      auto* bars = new QCPErrorBars(xAxis, yAxis);
      bars->removeFromLegend();
      bars->setErrorType(type);
      bars->setDataPlottable(dot);
      bars->setPen(QPen(color, 1.5));
      bars->addData((band.median - band.low) * factor, (band.high - band.median) * factor);
    }
    most = std::max(most, x.high * effort.factor);
    mostMisses = std::max(mostMisses, y.high * misses.factor);
  }
  xAxis->setRange(0, most > 0 ? margin * most : effort.factor);
  yAxis->setRange(0, margin * mostMisses);
  replot(rpQueuedReplot);
}

void EffortPlot::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) redraw();
}

}  // namespace detent::editor
