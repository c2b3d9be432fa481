// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/window/margin_overlay.h"

#include <algorithm>
#include <cmath>
#include <QEvent>
#include <QPainter>
#include <QPolygonF>
#include <vector>

#include "editor/canvas/graph_painting.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double band_px = 11, hatch_px = 5;
constexpr double nearShare = 0.5;    // share of the allowed slope from which the margin is called small
constexpr std::size_t mostTags = 3;  // more would hide the graph
constexpr double tagAbove_px = 22;

enum class Ease { easy, near, over };

Ease easeOf(double slope_N_per_mm, double allowed_N_per_mm) {
  if (slope_N_per_mm > allowed_N_per_mm) return Ease::over;
  return slope_N_per_mm > nearShare * allowed_N_per_mm ? Ease::near : Ease::easy;
}

QColor bandColor(Ease ease, const GraphColors& colors) {
  QColor color = ease == Ease::over   ? colors.refused
                 : ease == Ease::near ? colors.tactilePoint
                                      : colors.operatingPoint;
  color.setAlphaF(ease == Ease::over ? 0.42F : 0.24F);
  return color;
}

void paintStretch(QPainter& painter, const QPolygonF& line, Ease ease, const GraphColors& colors) {
  if (line.size() < 2) return;
  painter.setPen(QPen(bandColor(ease, colors), band_px, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
  painter.drawPolyline(line);
  if (ease != Ease::over) return;
  // Hatched, so that the colour is not the only sign.
  QPen hatch(colors.refused, band_px, Qt::CustomDashLine, Qt::FlatCap, Qt::BevelJoin);
  hatch.setDashPattern({1.2 / band_px, hatch_px / band_px});
  painter.setPen(hatch);
  painter.drawPolyline(line);
}

/// Draws one curve in stretches of equal margin.
void paintCurveBand(QPainter& painter, const PlotMapping& map, const StrokeCurve& curve,
                    const std::vector<playback::MarginPoint>& points, const GraphColors& colors) {
  if (points.size() < 2) return;
  const double half_mm = 0.5 * (points[1].displacement_mm - points[0].displacement_mm);
  QPolygonF line;
  Ease ease = Ease::easy;
  for (const playback::MarginPoint& p : points) {
    const double from_mm = std::max(p.displacement_mm - half_mm, curve.start_mm());
    const double to_mm = std::min(p.displacement_mm + half_mm, curve.end_mm());
    if (from_mm >= to_mm) continue;
    const double from_N = curve.forceBefore_N(from_mm), to_N = curve.force_N(to_mm);
    const Ease here = easeOf(std::abs(to_N - from_N) / (2 * half_mm), p.allowed_N_per_mm);
    if (here != ease || line.isEmpty()) {
      paintStretch(painter, line, ease, colors);
      line = {map.toPixel(from_mm, from_N)};
      ease = here;
    }
    line << map.toPixel(to_mm, to_N);
  }
  paintStretch(painter, line, ease, colors);
}

}  // namespace

MarginOverlay::MarginOverlay(GraphCanvas& canvas, const ButtonDocument& document)
    : QWidget(&canvas), canvas_(canvas), document_(document) {
  setObjectName("marginOverlay");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("Slopes that the force device can reproduce without vibrating"));
  setGeometry(canvas.rect());
  canvas.installEventFilter(this);
  connect(&canvas, &UnitPlot::viewChanged, this, qOverload<>(&QWidget::update));
  connect(&document, &ButtonDocument::changed, this, qOverload<>(&QWidget::update));
  connect(&document, &ButtonDocument::activeStateChanged, this, qOverload<>(&QWidget::update));
  show();
}

void MarginOverlay::setMargin(std::shared_ptr<const playback::StabilityMargin> margin) {
  margin_ = std::move(margin);
  update();
}

bool MarginOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &canvas_ && event->type() == QEvent::Resize) setGeometry(canvas_.rect());
  return QWidget::eventFilter(watched, event);
}

void MarginOverlay::paintEvent(QPaintEvent*) {
  const std::size_t shown = document_.activeState();
  if (!margin_ || shown >= margin_->states.size()) return;
  const PlotMapping map = canvas_.mapping();
  const ButtonState& state = canvas_.state();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(map.clip_px);
  painter.setBrush(Qt::NoBrush);
  for (const Stroke stroke : {Stroke::press, Stroke::release})
    if (stroke == Stroke::press || state.graph.release())
      paintCurveBand(painter, map, state.graph.curve(stroke), margin_->states[shown], canvas_.colors());
  paintWorst(painter, map, state, shown);
}

void MarginOverlay::paintWorst(QPainter& painter, const PlotMapping& map, const ButtonState& state,
                               std::size_t shown) const {
  std::vector<playback::UnstableStretch> worst;
  for (const playback::UnstableStretch& stretch : margin_->unstable)
    if (stretch.state == shown) worst.push_back(stretch);
  std::sort(worst.begin(), worst.end(), [](const auto& a, const auto& b) {
    return a.worst.margin_N_per_mm() < b.worst.margin_N_per_mm();
  });
  worst.resize(std::min(worst.size(), mostTags));
  const DisplayUnits& units = canvas_.settings().units();
  for (const playback::UnstableStretch& stretch : worst) {
    const double at_mm = stretch.worst.displacement_mm;
    const QString text =
        tr("%1, device limit %2")
            .arg(quantityWithUnit(stretch.worst.slope_N_per_mm, Quantity::slope, units, 3),
                 quantityWithUnit(stretch.worst.allowed_N_per_mm, Quantity::slope, units, 3));
    const QPointF at = map.toPixel(at_mm, state.graph.press().force_N(at_mm)) - QPointF(0, tagAbove_px);
    paintTag(painter, at, text, canvas_.colors().refused, canvas_.colors().background, map.clip_px);
  }
}

}  // namespace detent::editor
