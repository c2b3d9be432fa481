// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/switch_map.h"

#include <array>
#include <cmath>
#include <QApplication>
#include <QHelpEvent>
#include <QToolTip>

#include "editor/canvas/plot_dress.h"
#include "editor/measured/measured_words.h"
#include "editor/panels/key_figures_model.h"

namespace detent::editor {
namespace {

constexpr double reach_px = 12;  // distance from a dot within which a click counts
constexpr double dotSize_px = 5, chosenSize_px = 9;
constexpr double margin = 1.05;  // around the outermost dots
constexpr double percent = 100;
constexpr std::array kinds{importer::SwitchKind::linear, importer::SwitchKind::between,
                           importer::SwitchKind::tactile};

/// Shapes differ too, so that no meaning depends on colour alone.
constexpr std::array shapes{QCPScatterStyle::ssDisc, QCPScatterStyle::ssDiamond, QCPScatterStyle::ssTriangle};

}  // namespace

SwitchMap::SwitchMap(const MeasuredTable& table, QWidget* parent) : QCustomPlot(parent), table_(table) {
  setFocusPolicy(Qt::StrongFocus);
  setInteractions(QCP::iRangeZoom);
  setSelectionRectMode(QCP::srmCustom);
  setNotAntialiasedElements(QCP::aeScatters);  // thousands of dots at once
  putLegendAbove(*this);
  for (std::size_t i = 0; i <= kinds.size(); ++i) {
    QCPGraph* graph = addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setAdaptiveSampling(false);
    if (i == kinds.size()) graph->removeFromLegend();
  }
  connect(this, &QCustomPlot::beforeReplot, this, &SwitchMap::bringUp);
  connect(selectionRect(), &QCPSelectionRect::accepted, this, [this](const QRect& rect, QMouseEvent* event) {
    std::set<SwitchIndex> inside;
    for (const Dot& dot : dots_)
      if (rect.normalized().contains(
              QPointF(xAxis->coordToPixel(dot.x), yAxis->coordToPixel(dot.y)).toPoint()))
        inside.insert(dot.which);
    choose(std::move(inside), event->modifiers());
  });
}

std::optional<double> SwitchMap::valueOf(SwitchIndex which, const MapScale& scale) const {
  if (!scale.figure) return table_.map().positions[which][scale.axis];
  const auto& value = table_.switches()[which].figures[*scale.figure];
  return value ? std::optional(shownFigure(*value, *scale.figure, units_)) : std::nullopt;
}

std::optional<SwitchMap::Dot> SwitchMap::dotOf(SwitchIndex which) const {
  const auto x = valueOf(which, x_), y = valueOf(which, y_);
  if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y)) return {};
  return Dot{which, *x, *y};
}

void SwitchMap::setScales(const MapScale& x, const MapScale& y) {
  if (x == x_ && y == y_) return;
  x_ = x;
  y_ = y;
  fitNext_ = true;
  redraw();
}

void SwitchMap::setUnits(const DisplayUnits& units) {
  units_ = units;
  fitNext_ = true;
  redraw();
}

void SwitchMap::setChosen(std::set<SwitchIndex> chosen) {
  chosen_ = std::move(chosen);
  if (!stale_) drawChosen();
  replot(rpQueuedReplot);
}

QString SwitchMap::titleOf(const MapScale& scale) const {
  if (scale.figure) return figureTitle(*scale.figure, units_);
  const importer::FeelAxis& axis = table_.map().axes[scale.axis];
  QString name = tr("Main difference %1").arg(scale.axis + 1);
  if (table_.switches().empty()) return name;
  const int share = static_cast<int>(std::lround(percent * axis.share));
  if (!axis.likest) return tr("%1: %2 %").arg(name).arg(share);
  return tr("%1: %2 %, %3").arg(name).arg(share).arg(termOf(*axis.likest));
}

void SwitchMap::dress() {
  dressPlot(*this);
  const bool dark = isDark(palette());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const QColor color = seriesColor(i, dark);
    graph(static_cast<int>(i))
        ->setScatterStyle(QCPScatterStyle(shapes[i], QPen(color), QBrush(color), dotSize_px));
    graph(static_cast<int>(i))->setName(kindWords(kinds[i]));
  }
  graph(static_cast<int>(kinds.size()))
      ->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(graphColors(dark).selection, 2),
                                        QBrush(Qt::NoBrush), chosenSize_px));
  xAxis->setLabel(titleOf(x_));
  yAxis->setLabel(titleOf(y_));
}

void SwitchMap::fill() {
  dots_.clear();
  std::array<QVector<double>, kinds.size()> x, y;
  for (const SwitchIndex which : table_.shown()) {
    const auto dot = dotOf(which);
    if (!dot) continue;
    dots_.push_back(*dot);
    const auto kind = static_cast<std::size_t>(importer::kindOf(table_.switches()[which].figures));
    x[kind] << dot->x;
    y[kind] << dot->y;
  }
  for (std::size_t i = 0; i < kinds.size(); ++i) graph(static_cast<int>(i))->setData(x[i], y[i]);
}

void SwitchMap::drawChosen() {
  QVector<double> x, y;
  for (const Dot& dot : dots_)
    if (chosen_.contains(dot.which)) {
      x << dot.x;
      y << dot.y;
    }
  graph(static_cast<int>(kinds.size()))->setData(x, y);
}

void SwitchMap::redraw() {
  stale_ = true;
  replot(rpQueuedReplot);
}

void SwitchMap::bringUp() {
  if (!stale_) return;
  stale_ = false;
  dress();
  fill();
  drawChosen();
  if (fitNext_ && !dots_.empty()) {
    rescaleAxes();
    for (QCPAxis* axis : {xAxis, yAxis}) axis->scaleRange(margin);
    fitNext_ = false;
  }
}

std::optional<QPointF> SwitchMap::placeOf(SwitchIndex which) {
  bringUp();
  for (const Dot& dot : dots_)
    if (dot.which == which) return QPointF(xAxis->coordToPixel(dot.x), yAxis->coordToPixel(dot.y));
  return {};
}

std::optional<SwitchIndex> SwitchMap::nearestTo(QPointF at_px) {
  bringUp();
  std::optional<SwitchIndex> nearest;
  double least_px = reach_px;
  for (const Dot& dot : dots_) {
    const double away_px =
        std::hypot(xAxis->coordToPixel(dot.x) - at_px.x(), yAxis->coordToPixel(dot.y) - at_px.y());
    if (away_px > least_px) continue;
    least_px = away_px;
    nearest = dot.which;
  }
  return nearest;
}

void SwitchMap::choose(std::set<SwitchIndex> switches, Qt::KeyboardModifiers keys) {
  if (keys & Qt::ControlModifier) switches.insert(chosen_.begin(), chosen_.end());
  setChosen(switches);
  emit chosen(switches);
}

void SwitchMap::mousePressEvent(QMouseEvent* event) {
  pressedAt_ = event->pos();
  QCustomPlot::mousePressEvent(event);
}

void SwitchMap::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = (event->pos() - pressedAt_).manhattanLength() < QApplication::startDragDistance();
  if (clicked && selectionRect()->isActive()) selectionRect()->cancel();
  QCustomPlot::mouseReleaseEvent(event);
  if (!clicked || event->button() != Qt::LeftButton) return;
  std::set<SwitchIndex> hit;
  if (const auto nearest = nearestTo(event->position())) hit.insert(*nearest);
  choose(std::move(hit), event->modifiers());
}

void SwitchMap::mouseDoubleClickEvent(QMouseEvent*) {
  fitNext_ = true;
  redraw();
}

void SwitchMap::changeEvent(QEvent* event) {
  QCustomPlot::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) redraw();
}

bool SwitchMap::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QCustomPlot::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto nearest = nearestTo(help->pos());
  if (!nearest) {
    QToolTip::hideText();
    return true;
  }
  QToolTip::showText(help->globalPos(), creditedTitle(table_.switches()[*nearest]), this);
  return true;
}

}  // namespace detent::editor
