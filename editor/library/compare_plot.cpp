// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/compare_plot.h"

#include <algorithm>
#include <QApplication>

#include "editor/canvas/plot_dress.h"
#include "editor/canvas/unit_ticker.h"
#include "editor/quantity/quantity.h"
#include "model/sampling.h"

namespace detent::editor {
namespace {

constexpr double roomBeyondBottomOut = 0.03;  // share of the travel
constexpr int digits = 4;
constexpr int namesInLine = 3;
constexpr double differenceHeight = 0.5;  // share of the graphs' height
constexpr int differenceSamples = 400;
constexpr int mostTicks = 5, leastTicks = 2;
constexpr double linesOfTick = 2.2;  // heights of a text line for each tick label
constexpr int leastName_px = 40;     // smallest width of a name in the legend

/// Empty beyond the curve's ends, and where a graph has no such stroke.
std::optional<double> forceAt(const ForceGraph& graph, Stroke stroke, double at_mm) {
  if (stroke == Stroke::release && !graph.release()) return {};
  const StrokeCurve& curve = graph.curve(stroke);
  if (at_mm < curve.start_mm() || at_mm > curve.end_mm()) return {};
  return curve.force_N(at_mm);
}

}  // namespace

ComparePlot::ComparePlot(QWidget* parent)
    : QCustomPlot(parent),
      cursor_(new QCPItemStraightLine(this)),
      pinned_(new QCPItemStraightLine(this)),
      margins_(new QCPMarginGroup(this)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  putLegendAbove(*this);
  legend->setWrap(namesInLine);
  axisRect()->setMarginGroup(QCP::msLeft, margins_);
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  for (QCPAxis* axis : {xAxis, yAxis}) axis->setTicker(QSharedPointer<UnitTicker>::create());
  for (QCPItemStraightLine* line : {cursor_, pinned_}) line->setVisible(false);
  connect(this, &QCustomPlot::afterLayout, this, &ComparePlot::fitTicks);
}

// Limits the number of tick labels to those for which an axis has space.
void ComparePlot::fitTicks() {
  bool changed = false;
  for (QCPAxisRect* rect : {axisRect(), differences_}) {
    if (!rect) continue;
    const double room = rect->height() / (linesOfTick * QFontMetricsF(yAxis->tickLabelFont()).height());
    const int count = std::clamp(static_cast<int>(room), leastTicks, mostTicks);
    const auto ticker = rect->axis(QCPAxis::atLeft)->ticker();
    changed |= ticker->tickCount() != count;
    ticker->setTickCount(count);
  }
  if (changed) replot(rpQueuedReplot);
}

// Puts names side by side; names without enough room are shortened in their middle.
void ComparePlot::fitNames(int width_px) {
  if (graphs_.empty()) return;
  const int inLine = std::min(namesInLine, static_cast<int>(graphs_.size()));
  const int beside_px = legend->iconSize().width() + legend->iconTextPadding() + legend->columnSpacing() +
                        legend->margins().left();
  const int room_px = std::max(leastName_px, width_px / inLine - beside_px);
  const QFontMetrics metrics(legend->font());
  for (int i = 0; i < legend->itemCount(); ++i)
    if (auto* item = qobject_cast<QCPPlottableLegendItem*>(legend->item(i)))
      item->plottable()->setName(
          metrics.elidedText(graphs_[static_cast<std::size_t>(i)].name, Qt::ElideMiddle, room_px));
}

void ComparePlot::resizeEvent(QResizeEvent* event) {
  fitNames(event->size().width());
  QCustomPlot::resizeEvent(event);
}

void ComparePlot::setGraphs(std::vector<ComparedGraph> graphs, const DisplayUnits& units) {
  graphs_ = std::move(graphs);
  units_ = units;
  dress();
  drawCurves();
  fitNames(width());
  place(*cursor_, cursor_mm_);
  place(*pinned_, pinned_mm_);
  replot();
  emit readingChanged(reading());
}

void ComparePlot::dress() {
  const GraphColors colors = dressPlot(*this);
  cursor_->setPen(QPen(colors.text, 1));
  pinned_->setPen(QPen(colors.selection, 1, Qt::DashLine));
  const QString displacement = tr("Displacement (%1)").arg(units_.lengthSymbol());
  xAxis->setLabel(differences_ ? QString() : displacement);
  yAxis->setLabel(tr("Force (%1)").arg(units_.forceSymbol()));
  if (!differences_) return;
  for (QCPAxis* axis : {differences_->axis(QCPAxis::atBottom), differences_->axis(QCPAxis::atLeft)})
    dressAxis(*axis, colors);
  differences_->axis(QCPAxis::atBottom)->setLabel(displacement);
  differences_->axis(QCPAxis::atLeft)->setLabel(tr("Difference (%1)").arg(units_.forceSymbol()));
}

void ComparePlot::showDifferences(bool shown) {
  if (shown == (differences_ != nullptr)) return;
  if (!shown) {
    clearPlottables();
    plotLayout()->remove(differences_);
    plotLayout()->simplify();
    differences_ = nullptr;
  } else {
    differences_ = new QCPAxisRect(this);
    differences_->setMarginGroup(QCP::msLeft, margins_);
    plotLayout()->addElement(plotLayout()->rowCount(), 0, differences_);
    plotLayout()->setRowStretchFactor(plotLayout()->rowCount() - 1, differenceHeight);
    for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft})
      differences_->axis(side)->setTicker(QSharedPointer<UnitTicker>::create());
    connect(xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), differences_->axis(QCPAxis::atBottom),
            qOverload<const QCPRange&>(&QCPAxis::setRange));
  }
  setGraphs(std::move(graphs_), units_);
}

// A name for each button; its release is the dashed line of the same colour.
void ComparePlot::drawCurves() {
  clearPlottables();
  const bool dark = isDark(palette());
  for (std::size_t i = 0; i < graphs_.size(); ++i)
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      const auto& [name, graph] = graphs_[i];
      if (stroke == Stroke::release && !graph.release()) continue;
      auto* curve = new QCPCurve(xAxis, yAxis);
      for (const CurvePoint& p : travelledSamples(graph, stroke))
        curve->addData(units_.lengthFrom(p.displacement_mm), units_.forceFrom(p.force_N));
      curve->setPen(QPen(seriesColor(i, dark), 2, stroke == Stroke::press ? Qt::SolidLine : Qt::DashLine));
      curve->setAntialiased(true);
      curve->setName(name);
      if (stroke == Stroke::release) curve->removeFromLegend();
    }
  if (graphs_.empty()) return;
  xAxis->rescale();
  xAxis->setRangeUpper(xAxis->range().upper + roomBeyondBottomOut * xAxis->range().size());
  yAxis->rescale();
  yAxis->scaleRange(1.1);
  yAxis->setRangeLower(
      // the axis begins at 0, so that differences appear in proportion
      std::min(0.0, yAxis->range().lower));
  if (differences_) drawDifferences();
}

void ComparePlot::drawDifferences() {
  QCPAxis *x = differences_->axis(QCPAxis::atBottom), *y = differences_->axis(QCPAxis::atLeft);
  const bool dark = isDark(palette());
  const ForceGraph& first = graphs_.front().graph;
  for (std::size_t i = 1; i < graphs_.size(); ++i)
    for (const Stroke stroke : {Stroke::press, Stroke::release}) {
      auto* curve = new QCPGraph(x, y);
      const double end_mm = std::max(first.travel_mm(), graphs_[i].graph.travel_mm());
      for (int k = 0; k <= differenceSamples; ++k) {
        const double at_mm = end_mm * k / differenceSamples;
        const auto here = forceAt(graphs_[i].graph, stroke, at_mm), there = forceAt(first, stroke, at_mm);
        if (here && there) curve->addData(units_.lengthFrom(at_mm), units_.forceFrom(*here - *there));
      }
      curve->setPen(QPen(seriesColor(i, dark), 2, stroke == Stroke::press ? Qt::SolidLine : Qt::DashLine));
      curve->setAntialiased(true);
      curve->removeFromLegend();
    }
  x->setRange(xAxis->range());
  y->rescale();
  if (y->range().size() > 0) y->scaleRange(1.1);
}

// ---- pictures for others

std::unique_ptr<ComparePlot> ComparePlot::forPicture(QSize size) const {
  auto plot = std::make_unique<ComparePlot>();
  plot->resize(size);
  plot->setViewport({{}, size});
  plot->setFont(font());
  plot->setPalette(QPalette(Qt::black, Qt::white, Qt::white, Qt::darkGray, Qt::gray, Qt::black, Qt::white));
  plot->showDifferences(differences_ != nullptr);
  plot->setGraphs(graphs_, units_);
  plot->xAxis->setRange(xAxis->range());
  plot->yAxis->setRange(yAxis->range());
  plot->replot();  // determines the axes' margins
  plot->replot();  // draws as many tick labels as fit
  return plot;
}

void ComparePlot::renderTo(QPaintDevice& device, QSize size) const {
  QCPPainter painter(&device);
  painter.setMode(QCPPainter::pmVectorized, true);
  painter.setMode(QCPPainter::pmNoCaching, true);
  forPicture(size)->toPainter(&painter, size.width(), size.height());
}

QImage ComparePlot::picture(QSize size_px, double devicePixelRatio) const {
  QImage image(size_px, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::white);
  image.setDevicePixelRatio(devicePixelRatio);
  QCPPainter painter(&image);
  const QSize size = (QSizeF(size_px) / devicePixelRatio).toSize();
  forPicture(size)->toPainter(&painter, size.width(), size.height());
  return image;
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
  for (const auto& [name, graph] : graphs_)
    parts << tr("%1 press %2, release %3")
                 .arg(name, shown(forceAt(graph, Stroke::press, at_mm)),
                      shown(forceAt(graph, Stroke::release, at_mm)));
  return tr("At %1: %2 (%3)")
      .arg(quantityWithUnit(at_mm, Quantity::length, units_, digits), parts.join(QStringLiteral("; ")),
           units_.forceSymbol());
}

QString ComparePlot::differences() const {
  QStringList parts;
  for (const auto& [name, graph] : graphs_) {
    const auto from = forceAt(graph, Stroke::press, *pinned_mm_),
               to = forceAt(graph, Stroke::press, *cursor_mm_);
    if (from && to)
      parts << tr("%1 press %2").arg(name, quantityWithUnit(*to - *from, Quantity::force, units_, digits));
  }
  return tr("Difference from the pinned cursor: %1; %2")
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
