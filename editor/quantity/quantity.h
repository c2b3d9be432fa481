// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The only code that reads and shows numbers with units: in fields, tables, dialogues, on axes and ticks.
//
// Reading is the same in every locale: both decimal signs, never a group separator (a possible one is
// refused, not guessed), any known unit, sums and products, and changes of the present value.

#include <optional>
#include <QString>

#include "editor/document/display_units.h"
#include "editor/document/number_text.h"
#include "editor/quantity/expression.h"

namespace detent::editor {

/// Meaning of a number; decides its units.
enum class Quantity {
  length,      ///< mm
  force,       ///< N
  slope,       ///< N/mm
  damping,     ///< N·s/mm
  share,       ///< of a whole, in percent: 30 and 30 % are 0.3
  number,      ///< without a unit
  count,       ///< a whole number
  resolution,  ///< dpi
};

/// Result of reading a text. `trouble`: the reason why there is no value; `culprit`: the part of the text
/// that causes it.
struct QuantityReading {
  std::optional<double> value;  ///< mm, N, N/mm, N·s/mm; else the number itself
  double shown = 0;             ///< the value in the shown unit; exactly the typed number if it had no unit
  QuantityTrouble trouble = QuantityTrouble::empty;
  QString culprit;
};

/// Reads
///   - a number, in the shown unit or with one of its own: "1.25", "1,25", "60 gf", "0.1 in", "20 N/mm";
///   - sums, differences, products, quotients and brackets of such: "50+5", "2*0.3 mm", "(1+2)/4 mm";
///   - a change of `now` (same unit as `value`): "+5", "-=5", "+10 %", "-10 %", "50 %". "-5" is the number
///   -5, "50 %" of a share the share itself.
/// Any thread.
QuantityReading readQuantity(const QString& text, Quantity quantity, const DisplayUnits& units,
                             std::optional<double> now = {});

/// The reason why a text was refused, and what can be typed instead, in one or two sentences.
QString refusalOf(const QuantityReading& reading, Quantity quantity, const DisplayUnits& units);

/// A question if a value is unusual for a button: more than 20 N or 30 mm in either direction; more than the
/// whole of a share, or less than a hundredth typed without a percent sign. "… Meant: 60 gf? …" proposes the
/// same number in a unit that fits, if there is one. Empty for usual values, slopes and all other quantities.
QString doubtOf(const QString& text, double value, Quantity quantity, const DisplayUnits& units);

/// Size of the shown unit in mm, N, N/mm; 0.01 for shares, 1 for numbers without a unit.
double shownUnitOf(Quantity quantity, const DisplayUnits& units);
/// "mm", "cN/mm", "N·s/mm", "%", "dpi"; empty if there is no unit.
QString symbolOf(Quantity quantity, const DisplayUnits& units);

/// A value (mm, N, ...) in the shown unit, without that unit.
QString quantityText(double value, Quantity quantity, const DisplayUnits& units, int significant = 5);
/// Text with the unit: "1.305 mm".
QString quantityWithUnit(double value, Quantity quantity, const DisplayUnits& units, int significant = 5);

}  // namespace detent::editor
