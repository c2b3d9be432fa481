// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/level_meter.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

#include "editor/document/graph_colors.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double number_px = 58;  // of the words beside the bar

double decibels(double level) {
  return level > 0 ? std::max(LevelMeter::lowest_dB, 20 * std::log10(level)) : LevelMeter::lowest_dB;
}

}  // namespace

LevelMeter::LevelMeter(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Output level"));
  setToolTip(
      tr("<p>Output level, in dB relative to full scale: the bar is the peak of the last 20 ms; the line and "
         "the number are the highest peak (held for 1.5 s).</p><p>“limited” appears while the limiter caps "
         "the level. Lower the gain to feel the button's true strength.</p>"));
}

QSize LevelMeter::sizeHint() const { return {220, 22}; }
QSize LevelMeter::minimumSizeHint() const { return {140, 20}; }

void LevelMeter::setLevel(double level, double ceiling, double time_s) {
  const double elapsed_s = idle_ ? 0 : std::max(0.0, time_s - time_s_);
  idle_ = false;
  time_s_ = time_s;
  ceiling_dB_ = decibels(ceiling);
  const double now_dB = decibels(level);
  shown_dB_ = std::max({now_dB, shown_dB_ - fall_dB_per_s * elapsed_s, lowest_dB});
  if (now_dB >= peak_dB_) {
    peak_dB_ = now_dB;
    peakAt_s_ = time_s;
  } else if (time_s - peakAt_s_ > hold_s) {
    peak_dB_ = std::max(shown_dB_, peak_dB_ - fall_dB_per_s * elapsed_s);
  }
  if (level >= limiting * ceiling) limitedAt_s_ = time_s;
  limited_ = level >= limiting * ceiling || (limited_ && time_s - limitedAt_s_ < hold_s);
  describe();
  update();
}

void LevelMeter::setIdle() {
  if (idle_) return;
  idle_ = true;
  limited_ = false;
  shown_dB_ = peak_dB_ = lowest_dB;
  describe();
  update();
}

void LevelMeter::describe() {
  const QString text = idle_ || peak_dB_ <= lowest_dB ? tr("silent")
                                                      : tr("peak %1 dB").arg(fixedText(peak_dB_, 0)) +
                                                            (limited_ ? tr(", limited") : QString());
  if (text != accessibleDescription()) setAccessibleDescription(text);
}

void LevelMeter::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const GraphColors colors = graphColors(isDark(palette()));
  QFont font = this->font();
  font.setPointSizeF(std::max(6.0, 0.85 * font.pointSizeF()));
  painter.setFont(font);
  const QRectF bar(0.5, 3.5, width() - number_px - 6, height() - 7);
  const auto x = [&](double dB) {
    return bar.left() + (std::clamp(dB, lowest_dB, 0.0) - lowest_dB) / -lowest_dB * bar.width();
  };
  painter.setPen(colors.grid);
  painter.setBrush(colors.background);
  painter.drawRect(bar);
  if (shown_dB_ > lowest_dB) {
    painter.fillRect(
        QRectF(QPointF(bar.left() + 1, bar.top() + 1), QPointF(x(shown_dB_), bar.bottom() - 0.5)),
        limited_ ? colors.refused : colors.operatingPoint);
  }
  painter.setPen(colors.grid);
  for (double dB = -50; dB < 0; dB += 10)
    painter.drawLine(QPointF(x(dB), bar.bottom() - 4), QPointF(x(dB), bar.bottom()));
  if (peak_dB_ > lowest_dB) {
    painter.setPen(QPen(colors.text, 2));
    painter.drawLine(QPointF(x(peak_dB_), bar.top() + 1), QPointF(x(peak_dB_), bar.bottom() - 1));
  }

  painter.setPen(limited_ ? colors.refused : colors.text);
  const QString words = limited_ ? tr("limited")
                        : peak_dB_ > lowest_dB
                            ? tr("%1 dB").arg(fixedText(peak_dB_, 1).replace('-', QChar(0x2212)))
                            : tr("silent");
  painter.drawText(rect(), Qt::AlignRight | Qt::AlignVCenter, words);
}

}  // namespace detent::editor
