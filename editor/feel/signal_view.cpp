// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/signal_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "editor/document/message_words.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

using playback::EventKind;

constexpr double left_px = 44, right_px = 12, top_px = 18, timeAxis_px = 30, marks_px = 22, noMarks_px = 6;
constexpr double lowestSpan = 0.1;  // share of full scale: a silent signal is not enlarged further

QFont small(const QFont& font) {
  QFont result = font;
  result.setPointSizeF(std::max(6.0, font.pointSizeF() * 0.8));
  return result;
}

/// Largest of 1, 2, 5 times a power of ten that gives at least `fewest` steps in `span`.
double niceStep(double span, int fewest) {
  const double raw = span / fewest;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power <= raw * (1 + 1e-9)) return factor * power;
  return power;
}

/// The drawn amplitude range. It has only a few steps, so that the scale does not change with every move of a
/// dragged point.
double amplitudeSpan(double peak) {
  for (const double span : {lowestSpan, 0.25, 0.5})
    if (peak <= span) return span;
  return 1;
}

QString eventName(EventKind kind) {
  switch (kind) {
    case EventKind::grain:
      return SignalView::tr("pulse");
    case EventKind::pressJump:
      return SignalView::tr("press jump");
    case EventKind::releaseJump:
      return SignalView::tr("release jump");
    case EventKind::bottomOut:
      return SignalView::tr("bottom-out");
    case EventKind::contactClosed:
      return SignalView::tr("contact closes");
    case EventKind::contactOpened:
      return SignalView::tr("contact opens");
    case EventKind::trigger:
      break;
  }
  return SignalView::tr("triggered from outside");
}

QColor eventColor(EventKind kind, const GraphColors& colors) {
  switch (kind) {
    case EventKind::pressJump:
      return colors.press;
    case EventKind::releaseJump:
      return colors.release;
    case EventKind::bottomOut:
      return colors.refused;
    case EventKind::contactClosed:
      return colors.operatingPoint;
    case EventKind::contactOpened:
      return colors.resetPoint;
    case EventKind::grain:
    case EventKind::trigger:
      break;
  }
  return colors.axis;
}

double timeOf(const playback::EngineEvent& event) { return static_cast<double>(event.frame) / drawnRate_Hz; }

QImage pictureOf(const playback::Spectrogram& s) {
  if (s.columns == 0) return {};
  QImage image(static_cast<int>(s.columns), static_cast<int>(s.rows), QImage::Format_RGB32);
  std::array<QRgb, 256> palette{};
  for (std::size_t i = 0; i < palette.size(); ++i)
    palette[i] = levelColor(spectrogramFloor_dB * (1 - static_cast<double>(i) / 255), spectrogramFloor_dB);
  for (std::size_t row = 0; row < s.rows; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(static_cast<int>(s.rows - 1 - row)));
    for (std::size_t column = 0; column < s.columns; ++column) {
      const double share = 1 - static_cast<double>(s.at(column, row)) / spectrogramFloor_dB;
      line[column] = palette[static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * 255)];
    }
  }
  return image;
}

}  // namespace

QRgb levelColor(double level_dB, double floor_dB) {
  // Nine colours of viridis (S. van der Walt, N. Smith, 2015; CC0).
  constexpr std::array<std::array<int, 3>, 9> colours{{{68, 1, 84},
                                                       {71, 44, 122},
                                                       {59, 81, 139},
                                                       {44, 113, 142},
                                                       {33, 144, 141},
                                                       {39, 173, 129},
                                                       {92, 200, 99},
                                                       {170, 220, 50},
                                                       {253, 231, 37}}};
  const double at = std::clamp(1 - level_dB / floor_dB, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), colours.size() - 2);
  const double share = at - static_cast<double>(low);
  const auto channel = [&](std::size_t c) {
    return static_cast<int>(std::lround(colours[low][c] + (colours[low + 1][c] - colours[low][c]) * share));
  };
  return qRgb(channel(0), channel(1), channel(2));
}

SignalView::SignalView(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Vibration of a press"));
  setToolTip(
      tr("<p>Above: the vibration of a press, as a share of full scale. The grey line is the force (or "
         "depth) it was pressed with: a standard press (120 ms down, 80 ms held, 100 ms up; a quarter more "
         "force than the bottom-out needs) or your own last one.</p><p>Below: its frequencies over time up "
         "to 1000 Hz (spectrogram; Hann window of 32 ms), from −60 to 0 dB of a full-scale sine.</p>"));
}

QSize SignalView::sizeHint() const { return {360, 300}; }
QSize SignalView::minimumSizeHint() const { return {240, 190}; }

void SignalView::setSignal(std::shared_ptr<const PressSignal> signal) {
  press_ = std::move(signal);
  const bool standard = !press_ || press_->standard;
  QString summary = press_ ? QString::fromStdString(press_->summary) : QString();
  if (press_ && press_->speed_mm_per_s)
    summary += tr("; pressed at %1 mm/s").arg(*press_->speed_mm_per_s, 0, 'g', 3);
  setDrawn(press_, standard ? tr("Vibration of a standard press") : tr("Vibration of my last press"),
           summary);
}

void SignalView::setReference(std::shared_ptr<const ReferenceDrawing> reference, const QString& name) {
  press_.reset();
  setAccessibleName(tr("Reference: %1").arg(name));
  setToolTip(
      tr("<p>A signal of another program, for comparison: above as a share of full scale, below as a "
         "spectrogram. The level has the same scale as that of the press. So has the time, unless one signal "
         "is four times longer than the other.</p>"));
  setDrawn(std::move(reference), tr("Reference: %1").arg(name), {});
}

void SignalView::setLeast(double duration_s, double peak) {
  if (duration_s == leastDuration_s_ && peak == leastPeak_) return;
  leastDuration_s_ = duration_s;
  leastPeak_ = peak;
  update();
}

void SignalView::setDrawn(std::shared_ptr<const DrawnSignal> signal, const QString& heading,
                          const QString& details) {
  signal_ = std::move(signal);
  heading_ = heading;
  picture_ = {};
  if (signal_ && !signal_->failure)
    setAccessibleDescription(tr("Peak %1 percent of full scale, %2 milliseconds. %3")
                                 .arg(100 * signal_->peak, 0, 'f', 0)
                                 .arg(1000 * signal_->duration_s(), 0, 'f', 0)
                                 .arg(details));
  update();
}

SignalView::Layout SignalView::layoutOf() const {
  Layout layout;
  const double width_px = std::max(10.0, width() - left_px - right_px);
  const double felt_px = press_ ? marks_px : noMarks_px;
  const double free_px = std::max(20.0, height() - top_px - timeAxis_px - felt_px);
  const double wave_px = 0.46 * free_px;
  layout.wave = {left_px, top_px, width_px, wave_px};
  layout.marks = {left_px, top_px + wave_px, width_px, felt_px};
  layout.spectrum = {left_px, top_px + wave_px + felt_px, width_px, free_px - wave_px};
  if (signal_ && !signal_->samples.empty())
    layout.duration_s = std::max(signal_->duration_s(), leastDuration_s_);
  return layout;
}

void SignalView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const GraphColors colors = graphColors(isDark(palette()));
  painter.fillRect(rect(), colors.background);
  painter.setFont(small(font()));
  if (!signal_ || signal_->failure) {
    painter.setPen(colors.axis);
    painter.setFont(font());
    const QString text =
        signal_ ? sentenceOf(*signal_->failure) : tr("The vibration of a press is drawn here.");
    painter.drawText(rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, text);
  } else {
    const Layout layout = layoutOf();
    paintWave(painter, layout, colors);
    if (press_) paintMarks(painter, layout, colors);
    paintSpectrum(painter, layout, colors);
    paintTime(painter, layout, colors);
    paintCursor(painter, layout, colors);
  }
  if (signal_) emit shown(signal_->revision);
}

void SignalView::paintWave(QPainter& painter, const Layout& layout, const GraphColors& colors) const {
  const QRectF& area = layout.wave;
  const double span = amplitudeSpan(std::max(signal_->peak, leastPeak_));
  const auto y = [&](double v) { return area.center().y() - v / span * (area.height() / 2 - 2); };
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(colors.grid);
  for (const double v : {-span, 0.0, span})
    painter.drawLine(QPointF(area.left(), y(v)), QPointF(area.right(), y(v)));
  painter.setPen(colors.axis);
  for (const double v : {-span, 0.0, span}) {
    const QString text = v == 0 ? QStringLiteral("0") : (v > 0 ? "+" : "−") + numberText(std::fabs(v));
    painter.drawText(QRectF(0, y(v) - 8, area.left() - 5, 16), Qt::AlignRight | Qt::AlignVCenter, text);
  }

  // The force that causes the signal, scaled to its own height.
  double strongest = 0;
  for (const playback::PressReading& r : signal_->press.readings) strongest = std::max(strongest, r.value);
  if (strongest > 0) {
    QPainterPath force;
    for (const playback::PressReading& r : signal_->press.readings) {
      const QPointF at(layout.toX(r.time_s), area.bottom() - r.value / strongest * (area.height() - 6) - 2);
      if (at.x() > area.right()) break;
      force.elementCount() == 0 ? force.moveTo(at) : force.lineTo(at);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.grid.darker(isDark(palette()) ? 70 : 115), 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(force);
  }

  // Draws the range of the samples of each device pixel, so that no peak is lost at any width.
  const double pixel = 1 / devicePixelRatioF();
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor(area.width() / pixel)));
  const std::vector<float>& samples = signal_->samples;
  const auto drawn = std::max(samples.size(), static_cast<std::size_t>(layout.duration_s * drawnRate_Hz));
  QPolygonF upper, lower;
  float previous = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t from = c * drawn / columns;
    const std::size_t to = std::max(from + 1, (c + 1) * drawn / columns);
    if (from >= samples.size()) break;
    float low = previous, high = previous;  // connected with the neighbouring column
    for (std::size_t i = from; i < to && i < samples.size(); ++i) {
      low = std::min(low, samples[i]);
      high = std::max(high, samples[i]);
      previous = samples[i];
    }
    const double x = area.left() + (static_cast<double>(c) + 0.5) * pixel;
    upper << QPointF(x, y(static_cast<double>(high)) - 0.4);
    lower << QPointF(x, y(static_cast<double>(low)) + 0.4);
  }
  std::reverse(lower.begin(), lower.end());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.press);
  painter.drawPolygon(upper + lower);

  painter.setPen(colors.text);
  const QString peak = tr("peak %1 %").arg(100 * signal_->peak, 0, 'f', 0);
  const QRectF line(area.left(), 1, area.width(), top_px - 3);
  const int room_px = static_cast<int>(area.width()) - painter.fontMetrics().horizontalAdvance(peak + "  ");
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(heading_, Qt::ElideMiddle, room_px));
  painter.setPen(colors.axis);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, peak);
}

void SignalView::paintMarks(QPainter& painter, const Layout& layout, const GraphColors& colors) const {
  const QRectF& area = layout.marks;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(colors.axis);
  painter.drawText(QRectF(0, area.top(), area.left() - 5, area.height()), Qt::AlignRight | Qt::AlignVCenter,
                   tr("felt"));
  const double middle = area.center().y();
  for (const playback::EngineEvent& event : signal_->events) {
    const double x = std::round(layout.toX(timeOf(event)));
    if (event.kind == EventKind::grain) {
      painter.setPen(colors.axis);
      painter.drawLine(QPointF(x, middle - 2), QPointF(x, middle + 3));
      continue;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(eventColor(event.kind, colors));
    painter.drawRect(QRectF(x - 1.5, area.top() + 3, 3, area.height() - 6));
  }
}

void SignalView::paintSpectrum(QPainter& painter, const Layout& layout, const GraphColors& colors) {
  const QRectF& area = layout.spectrum;
  const playback::Spectrogram& s = signal_->spectrogram;
  if (picture_.isNull()) picture_ = pictureOf(s);
  if (picture_.isNull()) return;
  const double highest_Hz = static_cast<double>(s.rows - 1) * s.row_Hz;
  const auto y = [&](double f) { return area.bottom() - f / highest_Hz * area.height(); };
  // Pixel centres are at the spectrogram's times and frequencies, so half a pixel lies beyond each edge.
  painter.save();
  painter.setClipRect(area);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const double half_s = s.hop_s / 2, half_Hz = s.row_Hz / 2;
  const double right = layout.toX((static_cast<double>(s.columns) - 0.5) * s.hop_s);
  painter.drawImage(
      QRectF(QPointF(layout.toX(-half_s), y(highest_Hz + half_Hz)), QPointF(right, y(-half_Hz))), picture_);
  painter.restore();

  painter.setRenderHint(QPainter::Antialiasing, false);
  for (double f = 0; f <= highest_Hz * (1 + 1e-9); f += 250) {
    painter.setPen(QColor(255, 255, 255, 40));
    painter.drawLine(QPointF(area.left(), y(f)), QPointF(area.right(), y(f)));
    painter.setPen(colors.axis);
    const double label = std::clamp(y(f), area.top() + 7, area.bottom() - 5);
    painter.drawText(QRectF(0, label - 8, area.left() - 5, 16), Qt::AlignRight | Qt::AlignVCenter,
                     fixedText(f, 0));
  }
  painter.setPen(QColor(255, 255, 255, 200));
  painter.drawText(area.adjusted(6, 3, -6, 0), Qt::AlignLeft | Qt::AlignTop, tr("Hz"));
}

void SignalView::paintTime(QPainter& painter, const Layout& layout, const GraphColors& colors) const {
  const double bottom = layout.spectrum.bottom();
  const double step_s = niceStep(layout.duration_s, std::max(2, static_cast<int>(layout.wave.width() / 90)));
  painter.setPen(colors.axis);
  for (double t = 0; t <= layout.duration_s; t += step_s) {
    const double x = std::round(layout.toX(t));
    painter.drawLine(QPointF(x, bottom), QPointF(x, bottom + 3));
    painter.drawText(QRectF(x - 30, bottom + 3, 60, 14), Qt::AlignHCenter | Qt::AlignTop,
                     fixedText(1000 * t, 0));
  }
  painter.drawText(QRectF(0, bottom + 3, left_px - 8, 14), Qt::AlignRight | Qt::AlignTop, tr("ms"));

  // Colour scale of levels.
  const QRectF bar(layout.wave.right() - 96, bottom + 19, 60, 7);
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  for (int i = 0; i <= 8; ++i)
    gradient.setColorAt(i / 8.0,
                        QColor(levelColor(spectrogramFloor_dB * (1 - i / 8.0), spectrogramFloor_dB)));
  painter.fillRect(bar, gradient);
  const QRectF text = bar.adjusted(-40, -5, 40, 5);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, tr("−60 dB"));
  painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, tr("0 dB"));
}

QString SignalView::readout(const Layout& layout) const {
  const double time_s = (cursor_->x() - layout.wave.left()) / layout.wave.width() * layout.duration_s;
  QString time = tr("%1 ms").arg(fixedText(1000 * time_s, 1));
  if (layout.spectrum.contains(*cursor_)) {
    const playback::Spectrogram& s = signal_->spectrogram;
    if (s.columns == 0) return time;
    const double share = (layout.spectrum.bottom() - cursor_->y()) / layout.spectrum.height();
    const double row =
        std::clamp(share * static_cast<double>(s.rows - 1), 0.0, static_cast<double>(s.rows - 1));
    const double column = std::clamp(time_s / s.hop_s, 0.0, static_cast<double>(s.columns - 1));
    const float level =
        s.at(static_cast<std::size_t>(std::lround(column)), static_cast<std::size_t>(std::lround(row)));
    return tr("%1   %2 Hz   %3 dB")
        .arg(time, fixedText(row * s.row_Hz, 0),
             level <= playback::lowestLevel_dB ? QStringLiteral("−∞")
                                               : fixedText(static_cast<double>(level), 1));
  }
  if (layout.marks.contains(*cursor_)) {
    const playback::EngineEvent* nearest = nullptr;
    for (const playback::EngineEvent& event : signal_->events) {
      const double far = std::fabs(layout.toX(timeOf(event)) - cursor_->x());
      if (far < 5 && (!nearest || far < std::fabs(layout.toX(timeOf(*nearest)) - cursor_->x()) ||
                      (nearest->kind == EventKind::grain && event.kind != EventKind::grain)))
        nearest = &event;
    }
    if (nearest != nullptr)
      return tr("%1 ms   %2 at %3 mm")
          .arg(fixedText(1000 * timeOf(*nearest), 1), eventName(nearest->kind),
               fixedText(nearest->displacement_mm, 3));
    return time;
  }
  const auto at = static_cast<std::size_t>(std::max(0.0, time_s * drawnRate_Hz));
  if (at >= signal_->samples.size()) return time;
  return tr("%1   %2 % of full scale")
      .arg(time, fixedText(100 * static_cast<double>(signal_->samples[at]), 1));
}

void SignalView::paintCursor(QPainter& painter, const Layout& layout, const GraphColors& colors) const {
  painter.setPen(colors.axis);
  const QRectF line(layout.wave.left(), layout.spectrum.bottom() + 15, layout.wave.width() - 140, 15);
  const bool inside = cursor_ && cursor_->x() >= layout.wave.left() && cursor_->x() <= layout.wave.right() &&
                      cursor_->y() >= layout.wave.top() && cursor_->y() <= layout.spectrum.bottom();
  if (!inside) return;
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, readout(layout));
  painter.setPen(QPen(colors.axis, 1, Qt::DotLine));
  const double x = std::round(cursor_->x());
  painter.drawLine(QPointF(x, layout.wave.top()), QPointF(x, layout.spectrum.bottom()));
}

void SignalView::mouseMoveEvent(QMouseEvent* event) {
  cursor_ = event->position();
  update();
}

void SignalView::leaveEvent(QEvent*) {
  cursor_.reset();
  update();
}

void SignalView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) update();
  QWidget::changeEvent(event);
}

}  // namespace detent::editor
