// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/force_meter.h"

#include <algorithm>
#include <cmath>
#include <QPainter>
#include <QStringList>

#include "editor/document/graph_colors.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr int rowHeight_px = 19;
constexpr double name_px = 62, barShare = 0.3;  // width of the names; share of the remaining width
constexpr double punctualShare = 0.999;         // below it the deadline bar warns
constexpr double noBalance_mJ = -5e-3;          // smaller imbalances are shown as 0.00

}  // namespace

ForceMeter::ForceMeter(ViewSettings& settings, QWidget* parent) : QWidget(parent), settings_(settings) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Force, energy and timing"));
  setToolTip(
      tr("<p><b>Force</b>: the commanded force, and the largest one allowed.</p><p><b>Energy</b>: energy "
         "that the finger has put into the button since rest, and how much of it was returned. A balance "
         "below 0 means that the button returned more than it stored.</p><p><b>On time</b>: share of control "
         "steps that began within 0.1 ms of their planned time, and the longest delay.</p>"));
  setIdle();
}

QSize ForceMeter::sizeHint() const { return {240, 3 * rowHeight_px}; }

void ForceMeter::setIdle() {
  bars_[0] = {tr("Force"), tr("none"), 0, false};
  bars_[1] = {tr("Energy"), QString(), 0, false};
  bars_[2] = {tr("On time"), QString(), 0, false};
  setAccessibleDescription(tr("no force"));
  update();
}

void ForceMeter::show(const playback::ForceStatus& status, const ForceEnergy& energy, double limit_N) {
  const DisplayUnits& units = settings_.units();
  const double force_N = status.last.force_N;
  bars_[0] = {tr("Force"),
              tr("%1 of %2")
                  .arg(quantityWithUnit(force_N, Quantity::force, units, 3),
                       quantityWithUnit(limit_N, Quantity::force, units, 3)),
              std::abs(force_N) / limit_N, status.guard.faded + status.guard.tooFast > 0};
  const bool gave = energy.lowestBalance_mJ < noBalance_mJ;
  bars_[1] = {tr("Energy"),
              gave ? tr("%1 mJ, balance %2 mJ")
                         .arg(fixedText(energy.held_mJ, 2), fixedText(energy.lowestBalance_mJ, 2))
                   : tr("%1 mJ, %2 of %3 returned")
                         .arg(fixedText(energy.held_mJ, 2), fixedText(energy.givenBack_mJ, 2),
                              fixedText(energy.most_mJ, 2)),
              energy.most_mJ > 0 ? energy.held_mJ / energy.most_mJ : 0, gave};
  const double punctual =
      status.steps > 0 ? static_cast<double>(status.within100us) / static_cast<double>(status.steps) : 1;
  bars_[2] = {
      tr("On time"),
      tr("%1 %, max. %2 ms late").arg(fixedText(100 * punctual, 1), fixedText(1000 * status.worstLate_s, 1)),
      punctual, punctual < punctualShare};
  QStringList words;
  for (const Bar& bar : bars_) words << tr("%1: %2").arg(bar.name, bar.text);
  setAccessibleDescription(words.join(QStringLiteral("; ")));
  update();
}

void ForceMeter::paintBar(QPainter& painter, const QRectF& row, const Bar& bar) const {
  const GraphColors colors = graphColors(isDark(palette()));
  painter.setPen(colors.axis);
  painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, bar.name);
  QRectF box = row.adjusted(name_px, 4.5, 0, -4.5);
  box.setWidth(barShare * box.width());
  painter.setPen(colors.grid);
  painter.setBrush(colors.background);
  painter.drawRect(box);
  QRectF filled = box.adjusted(1, 1, -0.5, -0.5);
  filled.setWidth(std::clamp(bar.share, 0.0, 1.0) * filled.width());
  painter.fillRect(filled, bar.bad ? colors.refused : colors.operatingPoint);
  painter.setPen(bar.bad ? colors.refused : colors.text);
  painter.drawText(row.adjusted(box.right() - row.left() + 8, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                   bar.text);
}

void ForceMeter::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QFont font = this->font();
  font.setPointSizeF(std::max(6.0, 0.85 * font.pointSizeF()));
  painter.setFont(font);
  for (int i = 0; i < 3; ++i) paintBar(painter, QRectF(0, i * rowHeight_px, width(), rowHeight_px), bars_[i]);
}

}  // namespace detent::editor
