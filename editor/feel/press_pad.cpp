// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/press_pad.h"

#include <algorithm>
#include <cmath>
#include <QLinearGradient>
#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <QTouchEvent>

#include "editor/document/graph_colors.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

constexpr double flash_ms = 250;
constexpr int frame_ms = 16;
constexpr double side_px = 62;      // width of the scales beside the cap
constexpr double lampTop_px = 30;   // the lamps
constexpr double bottom_px = 46;    // height of the read-out
constexpr double dragOfPad = 0.55;  // a drag over this share of the pad's height covers the whole travel
// share of the area's height; the cap takes the rest and ends at the floor
constexpr double travelOfCap = 0.32;
constexpr double floor_px = 14;

bool isPressKey(int key) { return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter; }

/// Alignment flags for QPainter.
int flags(Qt::Alignment alignment) { return static_cast<int>(alignment.toInt()); }

QFont scaled(const QFont& font, double factor, bool bold = false) {
  QFont result = font;
  result.setPointSizeF(std::max(6.0, font.pointSizeF() * factor));
  result.setBold(bold);
  return result;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto part = [share](double x, double y) { return static_cast<float>(x + (y - x) * share); };
  return QColor::fromRgbF(part(a.redF(), b.redF()), part(a.greenF(), b.greenF()), part(a.blueF(), b.blueF()));
}

}  // namespace

PressPad::PressPad(ViewSettings& settings, QWidget* parent) : QWidget(parent), settings_(settings) {
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Press pad"));
  setAccessibleDescription(
      tr("Press and hold Space or Enter to press the button. Mouse, pen and touch press it too."));
  setToolTip(
      tr("<p>Press the button: hold <b>Space</b> or <b>Enter</b>, the mouse button, a finger, or a pen (its "
         "pressure is the force).</p><p>The scales show depth and force; indicators light up for what is "
         "felt.</p>"));
  clock_.start();
  connect(&settings_, &ViewSettings::changed, this, qOverload<>(&QWidget::update));
}

QSize PressPad::sizeHint() const { return {360, 260}; }
QSize PressPad::minimumSizeHint() const { return {240, 190}; }

void PressPad::setButton(std::optional<PadButton> button, const QString& why) {
  button_ = std::move(button);
  why_ = why;
  update();
}

void PressPad::setMotion(const PadMotion& motion) {
  motion_ = motion;
  update();
}

void PressPad::flash(Lamp lamp) {
  flashed_ms_[static_cast<int>(lamp)] = clock_.elapsed();
  if (fadeTimer_ == 0) fadeTimer_ = startTimer(frame_ms);
}

double PressPad::lampGlow(Lamp lamp) const {
  const auto age_ms = static_cast<double>(clock_.elapsed() - flashed_ms_[static_cast<int>(lamp)]);
  return std::clamp(1 - age_ms / flash_ms, 0.0, 1.0);
}

void PressPad::timerEvent(QTimerEvent*) {
  update();
  for (const Lamp lamp : {Lamp::pressJump, Lamp::releaseJump, Lamp::bottomOut})
    if (lampGlow(lamp) > 0) return;
  killTimer(fadeTimer_);
  fadeTimer_ = 0;
}

// ---- input

// Begins a press, unless another source holds the button.
bool PressPad::begin(Source source, double y_px, bool byPressure) {
  if (held_ || !button_) return false;
  held_ = source;
  heldFrom_px_ = y_px;
  timed_ = !byPressure && (source == Source::key || drive_ == Drive::time);
  byForce_ = byPressure || drive_ == Drive::force;
  if (timed_) emit timedDown();
  return true;
}

void PressPad::move(Source source, double y_px, double pressure) {
  if (held_ != source || timed_) return;
  const double share = source == Source::pen || pressure >= 0 ? pressure : dragShare(y_px);
  if (byForce_) {
    emit forceMoved(std::clamp(share, 0.0, 1.0));
  } else {
    emit depthMoved(std::clamp(share, 0.0, 1.0));
  }
}

void PressPad::end(Source source) {
  if (held_ != source) return;
  held_.reset();
  if (timed_) {
    emit timedUp();
  } else {
    emit lifted();
  }
}

double PressPad::dragShare(double y_px) const {
  return (y_px - heldFrom_px_) / std::max(40.0, dragOfPad * height());
}

void PressPad::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) {
    QWidget::mousePressEvent(event);
    return;
  }
  setFocus(Qt::MouseFocusReason);
  if (begin(Source::mouse, event->position().y(), false)) move(Source::mouse, event->position().y(), -1);
}

void PressPad::mouseMoveEvent(QMouseEvent* event) { move(Source::mouse, event->position().y(), -1); }

void PressPad::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) end(Source::mouse);
}

void PressPad::tabletEvent(QTabletEvent* event) {
  event->accept();  // otherwise Qt converts it to a mouse event
  switch (event->type()) {
    case QEvent::TabletPress:
      setFocus(Qt::MouseFocusReason);
      if (begin(Source::pen, event->position().y(), true)) move(Source::pen, 0, event->pressure());
      break;
    case QEvent::TabletMove:
      move(Source::pen, 0, event->pressure());
      break;
    case QEvent::TabletRelease:
      end(Source::pen);
      break;
    default:
      break;
  }
}

bool PressPad::touch(QTouchEvent& event) {
  event.accept();
  if (event.type() == QEvent::TouchEnd || event.type() == QEvent::TouchCancel || event.points().isEmpty()) {
    end(Source::touch);
    return true;
  }
  const QEventPoint& first = event.points().first();
  const bool feelsPressure = event.device() != nullptr &&
                             event.device()->capabilities().testFlag(QInputDevice::Capability::Pressure);
  if (event.type() == QEvent::TouchBegin) {
    setFocus(Qt::MouseFocusReason);
    begin(Source::touch, first.position().y(), feelsPressure);
  }
  if (first.state() == QEventPoint::State::Released) {
    end(Source::touch);
  } else {
    move(Source::touch, first.position().y(), feelsPressure ? first.pressure() : -1);
  }
  return true;
}

bool PressPad::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      return touch(*static_cast<QTouchEvent*>(event));
    case QEvent::ShortcutOverride: {
      // A window shortcut on Space or Enter must not intercept the press.
      auto* key = static_cast<QKeyEvent*>(event);
      if (isPressKey(key->key()) && key->modifiers() == Qt::NoModifier) event->accept();
      break;
    }
    default:
      break;
  }
  return QWidget::event(event);
}

void PressPad::keyPressEvent(QKeyEvent* event) {
  if (!isPressKey(event->key())) {
    QWidget::keyPressEvent(event);
    return;
  }
  if (event->isAutoRepeat() || !begin(Source::key, 0, false)) return;
  heldKey_ = event->key();
}

void PressPad::keyReleaseEvent(QKeyEvent* event) {
  if (!isPressKey(event->key())) {
    QWidget::keyReleaseEvent(event);
    return;
  }
  if (!event->isAutoRepeat() && event->key() == heldKey_) end(Source::key);
}

// Another widget will get the event of the key's release, so the press ends here.
void PressPad::focusOutEvent(QFocusEvent* event) {
  end(Source::key);
  QWidget::focusOutEvent(event);
}

void PressPad::hideEvent(QHideEvent* event) {
  if (held_) end(*held_);
  QWidget::hideEvent(event);
}

// ---- drawing

double PressPad::depthShare(double displacement_mm) const {
  const double travel_mm = button_->end_mm - button_->start_mm;
  return travel_mm > 0 ? std::clamp((displacement_mm - button_->start_mm) / travel_mm, 0.0, 1.0) : 0;
}

QRectF PressPad::capArea() const {
  const QRectF all = QRectF(rect()).adjusted(side_px, lampTop_px, -side_px, -bottom_px);
  const double width = std::min(all.width() - 12, 1.5 * all.height());
  return {all.center().x() - width / 2, all.top() + 6, width, all.height() - 12};
}
QRectF PressPad::scaleArea() const {
  return {10, lampTop_px + 8, side_px - 14, height() - lampTop_px - bottom_px - 16};
}
QRectF PressPad::forceArea() const {
  return {width() - side_px + 4, lampTop_px + 8, side_px - 14, height() - lampTop_px - bottom_px - 16};
}

void PressPad::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const GraphColors colors = graphColors(isDark(palette()));
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : colors.grid, hasFocus() ? 2 : 1));
  painter.setBrush(colors.background);
  painter.drawRoundedRect(frame.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  if (!button_) {
    painter.setPen(colors.axis);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     why_.isEmpty() ? tr("Open a button to press it.") : why_);
    return;
  }
  paintDepth(painter);
  paintForce(painter);
  paintCap(painter);
  paintReadout(painter);
}

void PressPad::paintDepth(QPainter& painter) const {
  const GraphColors colors = graphColors(isDark(palette()));
  const QRectF area = scaleArea();
  const double x = area.left() + 14;
  const auto y = [&](double mm) { return area.top() + depthShare(mm) * area.height(); };
  painter.setPen(QPen(colors.grid, 6, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  painter.setPen(QPen(motion_.releasing ? colors.release : colors.press, 6, Qt::SolidLine, Qt::RoundCap));
  if (motion_.pressed) painter.drawLine(QPointF(x, area.top()), QPointF(x, y(motion_.displacement_mm)));

  // Tactile points stand on the side of their stroke: press to the left, release to the right.
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.tactilePoint);
  const auto wedge = [&](double mm, double side) {
    const QPointF tip(x + side * 5, y(mm));
    painter.drawPolygon(QPolygonF{tip, tip + QPointF(side * 7, -4), tip + QPointF(side * 7, 4)});
  };
  for (const TactilePoint& point : button_->pressPoints) wedge(point.displacement_mm, -1);
  for (const TactilePoint& point : button_->releasePoints) wedge(point.displacement_mm, 1);
  const auto line = [&](const std::optional<double>& mm, const QColor& color) {
    if (!mm) return;
    painter.setPen(QPen(color, 2));
    painter.drawLine(QPointF(x - 8, y(*mm)), QPointF(x + 8, y(*mm)));
  };
  line(button_->operating_mm, colors.operatingPoint);
  line(button_->reset_mm, colors.resetPoint);

  painter.setFont(scaled(font(), 0.8));
  painter.setPen(colors.axis);
  const DisplayUnits& units = settings_.units();
  const QRectF label(x + 14, area.top() - 8, side_px - 20, 16);
  // A curve that was read from a page may start slightly off zero.
  const bool startsAtZero = std::abs(button_->start_mm) < button_->end_mm / 2000;
  painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter,
                   numberText(units.lengthFrom(startsAtZero ? 0 : button_->start_mm), 3));
  painter.drawText(label.translated(0, area.height()), Qt::AlignLeft | Qt::AlignVCenter,
                   numberText(units.lengthFrom(button_->end_mm), 3));
}

void PressPad::paintForce(QPainter& painter) const {
  const GraphColors colors = graphColors(isDark(palette()));
  const QRectF area = forceArea();
  const double x = area.right() - 8;
  const auto y = [&](double N) {
    return area.bottom() - std::clamp(N / button_->full_N, 0.0, 1.0) * area.height();
  };
  painter.setPen(QPen(colors.grid, 6, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
  painter.setPen(QPen(motion_.releasing ? colors.release : colors.press, 6, Qt::SolidLine, Qt::RoundCap));
  if (motion_.pressed) painter.drawLine(QPointF(x, area.bottom()), QPointF(x, y(motion_.force_N)));
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.tactilePoint);
  for (const TactilePoint& point : button_->pressPoints) {
    const QPointF tip(x - 5, y(point.force_N));
    painter.drawPolygon(QPolygonF{tip, tip + QPointF(-7, -4), tip + QPointF(-7, 4)});
  }
  painter.setFont(scaled(font(), 0.8));
  painter.setPen(colors.axis);
  const QRectF label(x - side_px, area.top() - 8, side_px - 14, 16);
  painter.drawText(label, Qt::AlignRight | Qt::AlignVCenter,
                   numberText(settings_.units().forceFrom(button_->full_N), 3));
  painter.drawText(label.translated(0, area.height()), Qt::AlignRight | Qt::AlignVCenter, "0");
}

/// A section through the button: the well, and the cap at its depth.
void PressPad::paintCap(QPainter& painter) const {
  const bool dark = isDark(palette());
  const GraphColors colors = graphColors(dark);
  const QRectF area = capArea();
  const double travel_px = travelOfCap * area.height();
  const double capHeight_px = std::max(10.0, area.height() - travel_px - floor_px);
  const double depth_px =
      depthShare(motion_.pressed ? motion_.displacement_mm : button_->start_mm) * travel_px;
  const double wellTop = area.top() + travel_px * 0.75;

  const QRectF well(area.left(), wellTop, area.width(), area.bottom() - wellTop);
  painter.setPen(QPen(colors.grid, 1));
  painter.setBrush(mixed(colors.background, colors.grid, dark ? 0.35 : 0.55));
  painter.drawRoundedRect(well, 8, 8);

  const double bottomOut = lampGlow(Lamp::bottomOut);
  const QRectF floor(well.left() + 12, well.bottom() - floor_px + 2, well.width() - 24, 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(mixed(colors.bottomOut, colors.refused, bottomOut));
  painter.drawRoundedRect(floor, 1.5, 1.5);

  const double capTop = area.top() + depth_px;
  const QRectF cap(area.left() + 0.07 * area.width(), capTop, 0.86 * area.width(), capHeight_px);
  const double jump = std::max(lampGlow(Lamp::pressJump), lampGlow(Lamp::releaseJump));
  const QColor face = mixed(dark ? QColor("#3d444d") : QColor("#f4f6f8"), colors.tactilePoint, 0.45 * jump);
  QLinearGradient shade(cap.topLeft(), cap.bottomLeft());
  shade.setColorAt(0, face.lighter(dark ? 125 : 104));
  shade.setColorAt(1, face.darker(dark ? 115 : 108));
  painter.setPen(
      QPen(motion_.pressed ? (motion_.releasing ? colors.release : colors.press) : colors.axis, 1.5));
  painter.setBrush(shade);
  painter.drawRoundedRect(cap, 10, 10);

  painter.setPen(colors.text);
  painter.setFont(scaled(font(), 1.15, true));
  const QRectF text = cap.adjusted(10, 6, -10, -6);
  const QString name =
      painter.fontMetrics().elidedText(button_->name, Qt::ElideRight, static_cast<int>(text.width()));
  const bool roomy = text.height() > 2.6 * painter.fontMetrics().height();
  painter.drawText(text, flags(Qt::AlignHCenter | (roomy ? Qt::AlignTop : Qt::AlignVCenter)), name);
  if (!roomy) return;
  painter.setPen(colors.axis);
  painter.setFont(scaled(font(), 0.85));
  const QString below = !button_->stateName.isEmpty() ? button_->stateName
                        : motion_.pressed             ? QString()
                        : drive_ == Drive::time       ? tr("hold to press")
                                                      : tr("drag down to press");
  painter.drawText(text, Qt::AlignHCenter | Qt::AlignBottom, below);
}

// True at the end of the travel, with or without an event of the engine, because not every curve ends in a
// bottom-out.
bool PressPad::isAtEnd() const {
  return motion_.pressed && button_ && motion_.displacement_mm >= button_->end_mm;
}

void PressPad::paintReadout(QPainter& painter) const {
  const GraphColors colors = graphColors(isDark(palette()));
  const DisplayUnits& units = settings_.units();
  struct Light {
    QString text;
    QColor color;
    double glow;
  };
  const Light lights[] = {
      {tr("contact"), colors.operatingPoint, motion_.contact ? 1.0 : 0.0},
      {tr("jump"), colors.tactilePoint, std::max(lampGlow(Lamp::pressJump), lampGlow(Lamp::releaseJump))},
      {tr("bottom-out"), colors.refused, isAtEnd() ? 1.0 : lampGlow(Lamp::bottomOut)}};
  painter.setFont(scaled(font(), 0.8));
  const QFontMetricsF metrics = painter.fontMetrics();
  double width_px = 0;
  for (const Light& light : lights) width_px += metrics.horizontalAdvance(light.text) + 34;
  double x = width() / 2.0 - (width_px - 16) / 2;
  for (const Light& light : lights) {
    const QPointF centre(x + 5, 16);
    painter.setPen(QPen(mixed(colors.axis, light.color, light.glow), 1));
    painter.setBrush(mixed(colors.background, light.color, light.glow));
    painter.drawEllipse(centre, 4.5, 4.5);
    painter.setPen(mixed(colors.axis, colors.text, light.glow));
    const double text_px = metrics.horizontalAdvance(light.text);
    painter.drawText(QRectF(x + 14, 6, text_px + 4, 20), Qt::AlignLeft | Qt::AlignVCenter, light.text);
    x += text_px + 34;
  }

  const auto number = [&](const QRectF& at, Qt::AlignmentFlag side, double value, const QString& unit,
                          const QString& what) {
    painter.setFont(scaled(font(), 1.35, true));
    painter.setPen(motion_.pressed ? colors.text : colors.axis);
    const QString text = motion_.pressed ? fixedText(value, value < 100 ? 2 : 1) : "–";
    painter.drawText(at, flags(side | Qt::AlignTop), text + " " + unit);
    painter.setFont(scaled(font(), 0.8));
    painter.setPen(colors.axis);
    painter.drawText(at, flags(side | Qt::AlignBottom), what);
  };
  const QRectF row(14, height() - bottom_px, width() - 28, bottom_px - 6);
  number(row, Qt::AlignLeft, units.lengthFrom(motion_.displacement_mm), units.lengthSymbol(), tr("depth"));
  number(row, Qt::AlignRight, units.forceFrom(motion_.force_N), units.forceSymbol(), tr("force"));
  painter.setPen(colors.axis);
  painter.drawText(row, Qt::AlignHCenter | Qt::AlignBottom,
                   !motion_.pressed    ? tr("Space · mouse · pen · touch")
                   : motion_.releasing ? tr("release stroke")
                                       : tr("press stroke"));
}

}  // namespace detent::editor
