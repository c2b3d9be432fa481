// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/press_strip.h"

#include <algorithm>
#include <cmath>
#include <QPainter>
#include <QPainterPath>

#include "editor/document/graph_colors.h"

namespace detent::editor {

using playback::EventKind;

PressStrip::PressStrip(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Last presses"));
  setToolTip(
      tr("<p>The last 3 seconds: depth of the finger (down is deeper), and what was felt.</p><p>Short ticks: "
         "vibration pulses of the slopes. Bars: jumps of the press and release stroke, bottom-out. The line "
         "above shows when the contact is closed.</p>"));
}

QSize PressStrip::sizeHint() const { return {360, 64}; }
QSize PressStrip::minimumSizeHint() const { return {200, 52}; }

void PressStrip::addMoment(const Moment& moment) {
  now_s_ = moment.time_s;
  moments_.push_back(moment);
  forget();
  update();
}

void PressStrip::addEvents(const std::vector<playback::EngineEvent>& events, double time_s,
                           double sampleRate_Hz) {
  if (events.empty()) return;
  const std::int64_t last = events.back().frame;
  for (const playback::EngineEvent& event : events) {
    const double earlier_s = static_cast<double>(last - event.frame) / sampleRate_Hz;
    events_.push_back({time_s - std::max(0.0, earlier_s), event.kind, event.count});
  }
  now_s_ = std::max(now_s_, time_s);
  forget();
  update();
}

void PressStrip::clear() {
  moments_.clear();
  events_.clear();
  update();
}

void PressStrip::forget() {
  const double oldest = now_s_ - span_s - 0.1;
  while (!moments_.empty() && moments_.front().time_s < oldest) moments_.pop_front();
  while (!events_.empty() && events_.front().time_s < oldest) events_.pop_front();
}

void PressStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const GraphColors colors = graphColors(isDark(palette()));
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(colors.grid);
  painter.setBrush(colors.background);
  painter.drawRoundedRect(frame, 4, 4);
  const QRectF area = frame.adjusted(6, 8, -6, -14);
  const QRectF lane(area.left(), area.bottom() + 2, area.width(), 10);
  const auto x = [&](double time_s) { return area.right() - (now_s_ - time_s) / span_s * area.width(); };
  painter.setClipRect(frame.adjusted(2, 1, -2, -1));

  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(colors.grid);
  for (double t = std::ceil(now_s_ - span_s); t < now_s_; t += 1)
    painter.drawLine(QPointF(x(t), area.top()), QPointF(x(t), area.bottom()));
  if (moments_.empty()) {
    painter.setPen(colors.axis);
    painter.drawText(frame, Qt::AlignCenter, tr("Live trace"));
    return;
  }

  for (const Felt& event : events_) {
    const double at = std::round(x(event.time_s));
    if (event.kind == EventKind::grain || event.kind == EventKind::trigger) {
      painter.setPen(colors.axis);
      painter.drawLine(QPointF(at, lane.top() + 2), QPointF(at, lane.bottom() - 2));
      continue;
    }
    if (event.kind == EventKind::contactClosed || event.kind == EventKind::contactOpened) continue;
    const QColor color = event.kind == EventKind::pressJump     ? colors.press
                         : event.kind == EventKind::releaseJump ? colors.release
                                                                : colors.refused;
    painter.fillRect(QRectF(at - 1.5, area.top(), 3, lane.bottom() - area.top()), color);
  }

  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 1; i < moments_.size(); ++i) {
    const Moment &a = moments_[i - 1], &b = moments_[i];
    if (b.time_s - a.time_s > 0.2) continue;  // the finger was not followed during this gap
    const auto y = [&](double depth) { return area.top() + std::clamp(depth, 0.0, 1.0) * area.height(); };
    painter.setPen(QPen(b.releasing ? colors.release : colors.press, 1.6));
    painter.drawLine(QPointF(x(a.time_s), y(a.depth)), QPointF(x(b.time_s), y(b.depth)));
    if (!a.contact || !b.contact) continue;
    painter.setPen(QPen(colors.operatingPoint, 3, Qt::SolidLine, Qt::SquareCap));
    painter.drawLine(QPointF(x(a.time_s), frame.top() + 4), QPointF(x(b.time_s), frame.top() + 4));
  }
}

}  // namespace detent::editor
