// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Several records of one switch by one laboratory: the variation between its units, which a single curve
// cannot show.

#include <cstddef>
#include <string>
#include <vector>

#include "model/key_figures.h"

namespace detent::importer {

/// One record of a switch: which unit of it, and its figures.
struct UnitRecord {
  std::string unit;  ///< see SwitchName; equal names mean the same unit
  KeyFigures figures;
};

struct SwitchSpread {
  std::size_t records = 1, units = 1;
  /// Standard deviation (n - 1) between the means of the units; with a single unit, between its records.
  /// Empty where fewer than two have the figure.
  KeyFigures sd;
};

/// Spread of the records of one switch. Any thread.
SwitchSpread spreadOf(const std::vector<UnitRecord>& records);

}  // namespace detent::importer
