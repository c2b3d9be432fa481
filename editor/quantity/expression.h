// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sums and products of numbers with units, as typed into a quantity field (quantity.h reads through this).

#include <optional>
#include <QString>

namespace detent::editor {

/// Reason why a text is not a quantity.
enum class QuantityTrouble {
  empty,
  noNumber,         ///< "about two", "5 +", an open bracket
  groupSeparator,   ///< "1,250.5", "1 250", "1'250"
  unknownUnit,      ///< "5 apples"
  otherQuantity,    ///< "5 gf" in place of a length
  mixedUnits,       ///< "50 + 5 gf" while cN are shown: which unit has the 50?
  nothingToChange,  ///< "+10 %" of no value
  notWhole,         ///< "1.5" of a count
  notFinite,
};

/// Returns true for the hyphen and for the minus sign U+2212.
inline bool isMinusSign(QChar c) { return c == QLatin1Char('-') || c == QChar(0x2212); }

/// Powers of N, mm and s in a unit.
struct Dimension {
  int force = 0, length = 0, time = 0;
  bool none() const { return force == 0 && length == 0 && time == 0; }
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A number in N, mm and s; without a dimension, the number as typed.
struct Amount {
  double amount = 0;
  Dimension dimension;
  double unit = 1;  ///< size of the unit it was typed in; NaN: several
};

struct Evaluation {
  Amount value;
  std::optional<QuantityTrouble> trouble;
  QString culprit;
};

/// `shown`, `shownSize`: dimension and size (in N, mm, s) of the unit that bare numbers have. Any thread.
Evaluation evaluate(const QString& text, Dimension shown, double shownSize);

}  // namespace detent::editor
