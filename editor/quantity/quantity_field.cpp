// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/quantity/quantity_field.h"

#include <algorithm>
#include <cmath>
#include <QAccessible>
#include <QEvent>
#include <QFocusEvent>
#include <QLineEdit>
#include <QToolTip>

#include "editor/document/graph_colors.h"

namespace detent::editor {
namespace {

constexpr int shownDigits = 6;
constexpr int widestDigits = 12;  // characters the field has room for, with its unit

// Step of the field: a hundredth of the next power of ten above the number. 0.55 is stepped by 0.01, 60 by 1.
double stepOf(double shown, double widest) {
  const double size = shown != 0 ? std::abs(shown) : 0.01 * std::max(widest, 1e-6);
  return std::pow(10.0, std::floor(std::log10(size) + 1e-9) - 1);
}

}  // namespace

QuantityField::QuantityField(Quantity quantity, const DisplayUnits& units, QWidget* parent)
    : QAbstractSpinBox(parent), quantity_(quantity), units_(units), range_{-1e12, 1e12} {
  setAccelerated(true);
  lineEdit()->setMaxLength(100);
  connect(lineEdit(), &QLineEdit::textEdited, this, &QuantityField::take);
  connect(this, &QAbstractSpinBox::editingFinished, this, &QuantityField::settle);
  showValue();
}

void QuantityField::setValue(double value) {
  value_ = before_ = std::clamp(value, range_.lowest, range_.highest);
  refuse({});
  showValue();
}

void QuantityField::setRange(QuantityRange range) {
  range_ = range;
  setValue(value_);
}

void QuantityField::setUnits(const DisplayUnits& units) {
  if (units == units_) return;
  units_ = units;
  refuse({});
  showValue();
}

void QuantityField::setLowestText(const QString& text) {
  lowestText_ = text;
  showValue();
}

void QuantityField::take(const QString& typed) {
  if (!lowestText_.isEmpty() && typed.trimmed().compare(lowestText_, Qt::CaseInsensitive) == 0) {
    value_ = range_.lowest;
    refuse({});
    emit valueChanged(value_);
    return;
  }
  const QuantityReading reading = readQuantity(typed, quantity_, units_, before_);
  if (!reading.value) return refuse(refusalOf(reading, quantity_, units_));
  if (const QString why = rangeRefusal(*reading.value); !why.isEmpty()) return refuse(why);
  refuse({});
  // If the shown text is typed again, the value keeps all its digits.
  const double read = typed.trimmed() == textOf(before_)
                          ? before_
                          : std::clamp(*reading.value, range_.lowest, range_.highest);
  if (read == value_) return;
  value_ = read;
  if (keyboardTracking()) emit valueChanged(value_);
}

// Refused text stays as typed, so that it can be corrected.
void QuantityField::settle() {
  if (!acceptable()) return;
  const bool untold = !keyboardTracking() && value_ != before_;
  before_ = value_;
  showValue();
  if (untold) emit valueChanged(value_);
}

void QuantityField::showValue() { lineEdit()->setText(textOf(value_)); }

QString QuantityField::textOf(double value) const {
  if (!lowestText_.isEmpty() && value == range_.lowest) return lowestText_;
  return quantityWithUnit(value, quantity_, units_, shownDigits);
}

QString QuantityField::rangeRefusal(double value) const {
  // The text of a bound has few digits, but counts as the bound.
  const double slack =
      std::pow(10.0, 1 - shownDigits) * std::max(std::abs(range_.lowest), std::abs(range_.highest));
  if (value >= range_.lowest - slack && value <= range_.highest + slack) return {};
  return tr("Between %1 and %2")
      .arg(quantityWithUnit(range_.lowest, quantity_, units_),
           quantityWithUnit(range_.highest, quantity_, units_));
}

void QuantityField::refuse(const QString& why) {
  if (why == refusal_) return;
  if (refusal_.isEmpty()) ownToolTip_ = toolTip();
  refusal_ = why;
  setToolTip(why.isEmpty() ? ownToolTip_ : why);
  setAccessibleDescription(why);
  mark();
  if (!why.isEmpty() && isVisible())
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), why, this);
  else
    QToolTip::hideText();
  emit refusalChanged();
}

void QuantityField::mark() {
  QPalette colors = lineEdit()->palette();
  const bool dark = isDark(palette());
  colors.setColor(QPalette::Text, acceptable() ? palette().color(QPalette::Text) : graphColors(dark).refused);
  lineEdit()->setPalette(colors);
}

void QuantityField::stepBy(int steps) {
  const double unit = shownUnitOf(quantity_, units_);
  const bool whole = quantity_ == Quantity::count;
  const double step = whole                               ? 1
                      : quantity_ == Quantity::resolution ? 50
                                                          : stepOf(value_ / unit, range_.highest / unit);
  const double shown = std::round((value_ / unit + steps * step) / step) * step;
  const double next = std::clamp(shown * unit, range_.lowest, range_.highest);
  const bool changes = next != value_;
  setValue(next);
  selectAll();
  if (changes) emit valueChanged(value_);
}

// Any text may be typed; its meaning or its fault is shown beside the field.
QValidator::State QuantityField::validate(QString&, int&) const { return QValidator::Acceptable; }
void QuantityField::fixup(QString&) const {}

QAbstractSpinBox::StepEnabled QuantityField::stepEnabled() const {
  StepEnabled enabled = StepNone;
  if (value_ < range_.highest) enabled |= StepUpEnabled;
  if (value_ > range_.lowest) enabled |= StepDownEnabled;
  return enabled;
}

QSize QuantityField::sizeHint() const {
  const QString widest = QString(widestDigits, QLatin1Char('0')) + symbolOf(quantity_, units_);
  const int width =
      std::max(fontMetrics().horizontalAdvance(widest), fontMetrics().horizontalAdvance(lowestText_));
  QSize size = QAbstractSpinBox::sizeHint();
  size.setWidth(width + 2 * size.height());
  return size;
}

void QuantityField::focusInEvent(QFocusEvent* event) {
  if (acceptable()) before_ = value_;
  QAbstractSpinBox::focusInEvent(event);
}

void QuantityField::changeEvent(QEvent* event) {
  QAbstractSpinBox::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) mark();
}

}  // namespace detent::editor
