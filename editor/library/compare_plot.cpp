// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/compare_plot.h"

#include <QApplication>

#include "editor/canvas/unit_ticker.h"
#include "editor/document/graph_colors.h"
#include "editor/quantity/quantity.h"
#include "model/sampling.h"

namespace detent::editor {
namespace {

constexpr int digits = 4;

/// Empty beyond the curve's ends, and where a graph has no such stroke.
std::optional<double> forceAt(const ForceGraph& graph, Stroke stroke, double at_mm) {
  if (stroke == Stroke::release && !graph.release()) return {};
  const StrokeCurve& curve = graph.curve(stroke);
  if (at_mm < curve.start_mm() || at_mm > curve.end_mm()) return {};
  return curve.force_N(at_mm);
}

}  // namespace

ComparePlot::ComparePlot(QWidget* parent)
    : QCustomPlot(parent), cursor_(new QCPItemStraightLine(this)), pinned_(new QCPItemStraightLine(this)) {
  setMinimumHeight(180);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  legend->setVisible(true);
  legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);  // one line above the curves
  plotLayout()->insertRow(0);
  plotLayout()->addElement(0, 0, legend);
  constexpr double noMoreThanNeeded = 1e-3;
  plotLayout()->setRowStretchFactor(0, noMoreThanNeeded);
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  for (QCPAxis* axis : {xAxis, yAxis}) axis->setTicker(QSharedPointer<UnitTicker>::create());
  for (QCPItemStraightLine* line : {cursor_, pinned_}) line->setVisible(false);
}

void ComparePlot::setGraphs(std::vector<ComparedGraph> graphs, const DisplayUnits& units) {
  graphs_ = std::move(graphs);
  units_ = units;
  dress();
  drawCurves();
  place(*cursor_, cursor_mm_);
  place(*pinned_, pinned_mm_);
  replot();
  emit readingChanged(reading());
}

void ComparePlot::dress() {
  const GraphColors colors = graphColors(isDark(palette()));
  setBackground(colors.background);
  for (QCPAxis* axis : {xAxis, yAxis}) {
    axis->setBasePen(QPen(colors.axis));
    axis->setTickPen(QPen(colors.axis));
    axis->setSubTickPen(QPen(colors.axis));
    axis->setTickLabelColor(colors.text);
    axis->setLabelColor(colors.text);
    axis->grid()->setPen(QPen(colors.grid));
    axis->grid()->setZeroLinePen(QPen(colors.axis));
  }
  legend->setTextColor(colors.text);
  legend->setBrush(QBrush(colors.background));
  legend->setBorderPen(QPen(colors.grid));
  cursor_->setPen(QPen(colors.text, 1));
  pinned_->setPen(QPen(colors.selection, 1, Qt::DashLine));
  xAxis->setLabel(tr("Displacement (%1)").arg(units_.lengthSymbol()));
  yAxis->setLabel(tr("Force (%1)").arg(units_.forceSymbol()));
}

void ComparePlot::drawCurves() {
  clearPlottables();
  const bool dark = isDark(palette());
  for (std::size_t i = 0; i < graphs_.size(); ++i)
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const auto& [letter, graph] = graphs_[i];
      if (stroke == Stroke::release && !graph.release()) continue;
      auto* curve = new QCPCurve(xAxis, yAxis);
      for (const CurvePoint& p : travelledSamples(graph, stroke))
        curve->addData(units_.lengthFrom(p.displacement_mm), units_.forceFrom(p.force_N));
      curve->setPen(QPen(seriesColor(i, dark), 2, stroke == Stroke::press ? Qt::SolidLine : Qt::DashLine));
      curve->setAntialiased(true);
      curve->setName(letter + " " + (stroke == Stroke::press ? tr("press") : tr("release")));
    }
  if (graphs_.empty()) return;
  rescaleAxes();
  yAxis->scaleRange(1.1);
}

// ---- cursors

double ComparePlot::millimetresAt(double x_px) const {
  return xAxis->pixelToCoord(x_px) / units_.lengthFrom(1);
}

void ComparePlot::place(QCPItemStraightLine& line, std::optional<double> at_mm) {
  line.setVisible(at_mm.has_value() && !graphs_.empty());
  if (!at_mm) return;
  const double x = units_.lengthFrom(*at_mm);
  line.point1->setCoords(x, 0);
  line.point2->setCoords(x, 1);
}

void ComparePlot::moveCursor(std::optional<double> at_mm) {
  if (at_mm == cursor_mm_) return;
  cursor_mm_ = at_mm;
  place(*cursor_, cursor_mm_);
  replot(rpQueuedReplot);
  emit readingChanged(reading());
}

void ComparePlot::pin(std::optional<double> at_mm) {
  pinned_mm_ = at_mm;
  place(*pinned_, pinned_mm_);
  replot(rpQueuedReplot);
  emit readingChanged(reading());
}

QString ComparePlot::valuesAt(double at_mm) const {
  const auto shown = [&](std::optional<double> force_N) {
    return force_N ? numberText(units_.forceFrom(*force_N), digits) : QStringLiteral("\u2013");
  };
  QStringList parts;
  for (const auto& [letter, graph] : graphs_)
    parts << tr("%1 press %2, release %3")
                 .arg(letter, shown(forceAt(graph, Stroke::press, at_mm)),
                      shown(forceAt(graph, Stroke::release, at_mm)));
  return tr("At %1: %2 (%3)")
      .arg(quantityWithUnit(at_mm, Quantity::length, units_, digits), parts.join(QStringLiteral("; ")),
           units_.forceSymbol());
}

QString ComparePlot::differences() const {
  QStringList parts;
  for (const auto& [letter, graph] : graphs_) {
    const auto from = forceAt(graph, Stroke::press, *pinned_mm_),
               to = forceAt(graph, Stroke::press, *cursor_mm_);
    if (from && to)
      parts << tr("%1 press %2").arg(letter, quantityWithUnit(*to - *from, Quantity::force, units_, digits));
  }
  return tr("From the pinned cursor: %1; %2")
      .arg(quantityWithUnit(*cursor_mm_ - *pinned_mm_, Quantity::length, units_, digits),
           parts.join(QStringLiteral("; ")));
}

QString ComparePlot::reading() const {
  if (graphs_.empty() || !cursor_mm_) return {};
  return pinned_mm_ ? valuesAt(*cursor_mm_) + '\n' + differences() : valuesAt(*cursor_mm_);
}

void ComparePlot::mouseMoveEvent(QMouseEvent* event) {
  QCustomPlot::mouseMoveEvent(event);
  const bool inside = axisRect()->rect().contains(event->pos());
  moveCursor(inside ? std::optional(millimetresAt(event->position().x())) : std::nullopt);
}

void ComparePlot::mousePressEvent(QMouseEvent* event) {
  pressedAt_ = event->pos();
  QCustomPlot::mousePressEvent(event);
}

// A click pins; a drag moves the plot.
void ComparePlot::mouseReleaseEvent(QMouseEvent* event) {
  QCustomPlot::mouseReleaseEvent(event);
  const int moved = (event->pos() - pressedAt_).manhattanLength();
  if (event->button() != Qt::LeftButton || moved >= QApplication::startDragDistance()) return;
  const double x_px = event->position().x();
  const bool onPinned = pinned_mm_ && std::abs(xAxis->coordToPixel(units_.lengthFrom(*pinned_mm_)) - x_px) <
                                          selectionTolerance();
  pin(onPinned ? std::nullopt : std::optional(millimetresAt(x_px)));
}

void ComparePlot::leaveEvent(QEvent* event) {
  QCustomPlot::leaveEvent(event);
  moveCursor({});
}

void ComparePlot::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && pinned_mm_) return pin({});
  QCustomPlot::keyPressEvent(event);
}

}  // namespace detent::editor
