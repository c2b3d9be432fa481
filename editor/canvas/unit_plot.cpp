// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/canvas/unit_plot.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/unit_ticker.h"
#include "model/check.h"

namespace detent::editor {
namespace {

constexpr double smallestSpan = 1e-6;  // mm or N: far below any instrument, far above a double's rounding
constexpr double largestSpan = 1e9;

QCPRange limited(double lower, double upper) {
  const double middle = lower + 0.5 * (upper - lower);
  const double span = std::clamp(upper - lower, smallestSpan, largestSpan);
  return {middle - 0.5 * span, middle + 0.5 * span};
}

}  // namespace

/// Draws the content where no widget is painted: pictures and SVG.
class UnitPlot::Content : public QCPLayerable {
 public:
  explicit Content(UnitPlot& plot) : QCPLayerable(&plot, QStringLiteral("overlay")), plot_(plot) {}

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override {
    applyAntialiasingHint(painter, false, QCP::aeOther);
  }
  void draw(QCPPainter* painter) override {
    if (!plot_.exporting_) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    plot_.drawContent(*painter, plot_.mapping());
    painter->restore();
  }

 private:
  UnitPlot& plot_;
};

UnitPlot::UnitPlot(ViewSettings& settings, PlotQuantity x, PlotQuantity y, QWidget* parent)
    : QCustomPlot(parent),
      settings_(settings),
      xQuantity_(x),
      yQuantity_(y),
      xTicker_(new UnitTicker),
      yTicker_(new UnitTicker) {
  // One buffer for all static content.
  layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmLogical);
  new Content(*this);  // QCustomPlot owns the object
  setInteractions(QCP::Interactions());
  setNoAntialiasingOnDrag(false);
  xAxis->setTicker(xTicker_);
  yAxis->setTicker(yTicker_);
  xAxis2->setVisible(true);
  yAxis2->setVisible(true);
  for (QCPAxis* axis : {xAxis2, yAxis2}) {
    axis->setTicks(false);
    axis->setTickLabels(false);
  }
  for (QCPAxis* axis : {xAxis, yAxis}) {
    axis->grid()->setSubGridVisible(false);
    axis->setTickLength(0, 4);
    axis->setSubTickLength(0, 2);
  }
  axisRect()->setMinimumMargins(QMargins(8, 10, 14, 8));
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 90);
  connect(&settings_, &ViewSettings::changed, this, &UnitPlot::applySettings);
  connect(this, &QCustomPlot::beforeReplot, this, [this] { backgroundStale_ = true; });
  connect(this, &QCustomPlot::afterLayout, this, [this] {
    if (!exporting_) emit viewChanged();
  });
  colors_ = graphColors(isDark(palette()));
  applySettings();
  applyColors();
}

double UnitPlot::unitOf(PlotQuantity quantity) const {
  const DisplayUnits& units = settings_.units();
  switch (quantity) {
    case PlotQuantity::displacement:
      return units.toMm(1);
    case PlotQuantity::force:
      return units.toN(1);
    case PlotQuantity::damping:
      return units.toSlope(1);  // force·s / length
  }
  return 1;
}

QString UnitPlot::labelOf(PlotQuantity quantity) const {
  const DisplayUnits& units = settings_.units();
  switch (quantity) {
    case PlotQuantity::displacement:
      return tr("Displacement (%1)").arg(units.lengthSymbol());
    case PlotQuantity::force:
      return tr("Force (%1)").arg(units.forceSymbol());
    case PlotQuantity::damping:
      return tr("Damping (%1·s/%2)").arg(units.forceSymbol(), units.lengthSymbol());
  }
  return {};
}

void UnitPlot::applySettings() {
  xTicker_->setUnit(unitOf(xQuantity_));
  yTicker_->setUnit(unitOf(yQuantity_));
  xAxis->setLabel(labelOf(xQuantity_));
  yAxis->setLabel(labelOf(yQuantity_));
  replot(QCustomPlot::rpQueuedReplot);
}

void UnitPlot::applyColors() {
  setBackground(QBrush(colors_.background));
  QFont labelFont = font();
  QFont tickFont = font();
  tickFont.setPointSizeF(std::max(6.0, font().pointSizeF() * 0.92));
  for (QCPAxis* axis : {xAxis, yAxis, xAxis2, yAxis2}) {
    axis->setBasePen(QPen(colors_.axis, 1));
    axis->setTickPen(QPen(colors_.axis, 1));
    axis->setSubTickPen(QPen(colors_.axis, 1));
    axis->setTickLabelColor(colors_.text);
    axis->setLabelColor(colors_.text);
    axis->setLabelFont(labelFont);
    axis->setTickLabelFont(tickFont);
  }
  QColor fine = colors_.grid;
  fine.setAlphaF(0.45F);
  for (QCPAxis* axis : {xAxis, yAxis}) {
    axis->grid()->setPen(QPen(colors_.grid, 1));
    axis->grid()->setSubGridPen(QPen(fine, 1));
    axis->grid()->setZeroLinePen(QPen(colors_.axis, 1));
  }
  replot(QCustomPlot::rpQueuedReplot);
}

void UnitPlot::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() != QEvent::PaletteChange && event->type() != QEvent::FontChange) return;
  colors_ = graphColors(isDark(palette()));
  if (!xTicker_) return;  // still being built
  applyColors();
  colorsChanged();
}

// QCustomPlot draws the gridline of a value through the centre of the pixel of its rounded-down position.
PlotMapping UnitPlot::mapping() const {
  const QRect rect = const_cast<UnitPlot*>(this)->axisRect()->rect();  // QCustomPlot has no const access
  const QCPRange x = xAxis->range(), y = yAxis->range();
  return {QRectF(rect), {rect.left() + 0.5, rect.bottom() + 0.5}, x.lower,
          y.lower,      std::max(1, rect.width()) / x.size(),     std::max(1, rect.height()) / y.size()};
}

void UnitPlot::showRange(const QRectF& range) {
  const QCPRange x = limited(range.left(), range.left() + range.width());
  const QCPRange y = limited(range.top(), range.top() + range.height());
  if (x == xAxis->range() && y == yAxis->range()) return;
  xAxis->setRange(x);
  yAxis->setRange(y);
  replot(QCustomPlot::rpQueuedReplot);
  emit viewChanged();
}

QRectF UnitPlot::shownRange() const {
  const QCPRange x = xAxis->range(), y = yAxis->range();
  return {x.lower, y.lower, x.size(), y.size()};
}

void UnitPlot::zoomAt(QPointF at_px, double factorX, double factorY) {
  const QPointF at = mapping().toPlot(at_px);
  const QRectF shown = shownRange();
  const double width = std::clamp(shown.width() / factorX, smallestSpan, largestSpan);
  const double height = std::clamp(shown.height() / factorY, smallestSpan, largestSpan);
  fitted_ = false;
  showRange({at.x() - (at.x() - shown.left()) * width / shown.width(),
             at.y() - (at.y() - shown.top()) * height / shown.height(), width, height});
}

void UnitPlot::zoomTo(const QRectF& part_px) {
  const PlotMapping map = mapping();
  fitted_ = false;
  showRange(QRectF(map.toPlot(part_px.bottomLeft()), map.toPlot(part_px.topRight())).normalized());
}

void UnitPlot::panBy(QPointF by_px) {
  const PlotMapping map = mapping();
  fitted_ = false;
  showRange(shownRange().translated(-by_px.x() / map.pxPerX, by_px.y() / map.pxPerY));
}

void UnitPlot::fit() {
  fitted_ = true;
  const QRectF content = contentRange();
  const double width = std::max(content.width(), smallestSpan);
  const double height = std::max(content.height(), smallestSpan);
  showRange(QRectF(content.left(), content.top(), width, height)
                .adjusted(-0.03 * width, -0.06 * height, 0.04 * width, 0.08 * height));
}

void UnitPlot::drawAsPicture(QCPPainter& painter, QSize size) {
  DETENT_CHECK(!isVisible(), "a picture is drawn by a plot of its own");
  exporting_ = true;
  spaceLabels(size);
  toPainter(&painter, size.width(), size.height());
  exporting_ = false;
}

// QCustomPlot would fill and blend its buffers with every frame; copying an opaque picture is faster.
void UnitPlot::refreshBackground() {
  const double ratio = devicePixelRatioF();
  background_ = QPixmap((QSizeF(size()) * ratio).toSize());
  background_.setDevicePixelRatio(ratio);
  background_.fill(colors_.background);
  QCPPainter painter(&background_);
  for (const auto& buffer : mPaintBuffers) buffer->draw(&painter);
  backgroundStale_ = false;
}

void UnitPlot::paintEvent(QPaintEvent* event) {
  const double ratio = devicePixelRatioF();
  if (ratio != bufferDevicePixelRatio()) {  // moved to another screen: QCustomPlot must redraw
    setBufferDevicePixelRatio(ratio);
    replot(QCustomPlot::rpQueuedRefresh);
  }
  if (backgroundStale_ || background_.size() != (QSizeF(size()) * ratio).toSize()) refreshBackground();
  QPainter painter(this);
  painter.setClipRegion(event->region());
  painter.drawPixmap(0, 0, background_);
  painter.setRenderHint(QPainter::Antialiasing);
  drawContent(painter, mapping());
}

void UnitPlot::resizeEvent(QResizeEvent* event) {
  spaceLabels(event->size());  // before QCustomPlot draws, else the ticks are those of the size before
  QCustomPlot::resizeEvent(event);
  emit viewChanged();
}

// Keeps a distance between labels.
void UnitPlot::spaceLabels(QSize size) {
  xTicker_->setTickCount(std::clamp(size.width() / 90, 2, 12));
  yTicker_->setTickCount(std::clamp(size.height() / 60, 2, 10));
}

void UnitPlot::wheelEvent(QWheelEvent* event) {
  const QPoint turned = event->angleDelta();
  const QPointF pixels = event->pixelDelta();
  if (event->modifiers() & Qt::ShiftModifier && !pixels.isNull()) {
    panBy(pixels);
  } else {
    // One notch of 120 units: a quarter closer. Alt zooms displacement only, Ctrl force only.
    const double steps = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    const double factor = std::pow(1.25, steps);
    const bool onlyX = event->modifiers() & Qt::AltModifier, onlyY = event->modifiers() & Qt::ControlModifier;
    zoomAt(event->position(), onlyY ? 1 : factor, onlyX ? 1 : factor);
  }
  event->accept();
}

bool UnitPlot::panWith(QMouseEvent* event, Qt::MouseButton button) {
  if (event->type() == QEvent::MouseButtonPress && event->button() == button) {
    panFrom_px_ = event->position();
    setCursor(Qt::ClosedHandCursor);
    return true;
  }
  if (!panFrom_px_) return false;
  if (event->type() == QEvent::MouseMove) {
    panBy(event->position() - *panFrom_px_);
    panFrom_px_ = event->position();
    return true;
  }
  if (event->type() == QEvent::MouseButtonRelease && event->button() == button) {
    panFrom_px_.reset();
    unsetCursor();
    return true;
  }
  return false;
}

void UnitPlot::mousePressEvent(QMouseEvent* event) { panWith(event, Qt::MiddleButton); }
void UnitPlot::mouseMoveEvent(QMouseEvent* event) { panWith(event, Qt::MiddleButton); }
void UnitPlot::mouseReleaseEvent(QMouseEvent* event) { panWith(event, Qt::MiddleButton); }
void UnitPlot::mouseDoubleClickEvent(QMouseEvent*) {}

}  // namespace detent::editor
