// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Sums and products of numbers with units, as typed into a quantity field (quantity.h reads through this).

#include <optional>
#include <QString>

#include "editor/quantity/quantity.h"

namespace detent::editor {

/// Powers of N, mm and s in a unit.
struct Dimension {
  int force = 0, length = 0, time = 0;
  bool none() const { return force == 0 && length == 0 && time == 0; }
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A number in N, mm and s; without a dimension: the number as typed.
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

/// `shown` and `shownSize`: dimension and size (in N, mm, s) of the unit bare numbers have. Any thread.
Evaluation evaluate(const QString& text, Dimension shown, double shownSize);

}  // namespace detent::editor
