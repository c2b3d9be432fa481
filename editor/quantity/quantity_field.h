// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A field for one quantity: reads typed text (quantity.h), shows refusals beside the field, steps with arrows
// and wheel.

#include <QAbstractSpinBox>

#include "editor/quantity/quantity.h"

namespace detent::editor {

/// Range of a QuantityField, in mm, N, ... (as QuantityReading::value).
struct QuantityRange {
  double lowest = 0, highest = 0;
};

/// Shows a value with its unit. While the user types, every readable text is the value at once. An unreadable
/// text stays as typed and is marked, with the reason as tool tip and description; the value stays the last
/// readable one. Changes ("+5") refer to the value before typing began. GUI thread.
class QuantityField : public QAbstractSpinBox {
  Q_OBJECT

 public:
  QuantityField(Quantity quantity, const DisplayUnits& units, QWidget* parent = nullptr);

  Quantity quantity() const { return quantity_; }
  const QuantityRange& range() const { return range_; }
  double value() const { return value_; }
  /// Sets the value, clamped to the range; discards typed text. Emits no signal.
  void setValue(double value);
  void setRange(QuantityRange range);
  void setUnits(const DisplayUnits& units);
  /// Shown instead of the lowest value of the range ("automatic").
  void setLowestText(const QString& text);
  /// Returns true if the text can be read and lies in the range.
  bool acceptable() const { return refusal_.isEmpty(); }
  /// The reason why it is not acceptable; empty if it is.
  const QString& refusal() const { return refusal_; }

  void stepBy(int steps) override;
  QValidator::State validate(QString& text, int& position) const override;
  void fixup(QString& text) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void valueChanged(double value);
  /// The result of acceptable() may have changed.
  void refusalChanged();

 protected:
  StepEnabled stepEnabled() const override;
  void focusInEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void take(const QString& typed);
  void settle();
  void showValue();
  void refuse(const QString& why);
  void mark();
  QString textOf(double value) const;
  QString rangeRefusal(double value) const;

  Quantity quantity_;
  DisplayUnits units_;
  QuantityRange range_;
  double value_ = 0;
  double before_ = 0;  ///< value when typing began
  QString lowestText_;
  QString refusal_;
  QString ownToolTip_;
};

}  // namespace detent::editor
