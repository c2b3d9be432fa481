// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Axis titles: their position, their text, and the unit they name.

#include <optional>
#include <string>

#include "importer/axes/axis_labels.h"
#include "importer/lexicon/printed_unit.h"

namespace detent::importer {

template <class Unit>
struct AxisTitle {
  std::optional<PrintedUnit<Unit>> unit;
  std::string text;           ///< the line that names the unit, or else the nearest one
  double factor = 1;          ///< printed in that line, for the axis' labels
  bool factorUnread = false;  ///< that line prints one that cannot be read
  /// the quantity that the nearest line names if it is neither displacement nor force, as printed: "kPa",
  /// "Time"; else empty
  std::string other;
};

/// Title below the labels or at the right end of the axis. Uses the document's own text; pixels are read only
/// if it has none.
AxisTitle<LengthUnit> readXTitle(GraphReading& r, const Box& labels);
/// Left of the labels reading upwards, above the top left corner, or beside the axis' upper end.
AxisTitle<ForceUnit> readYTitle(GraphReading& r, const Box& labels);
/// Title right of the labels of a second scale; no other place is searched.
AxisTitle<ForceUnit> readRightTitle(GraphReading& r, const Box& labels);

}  // namespace detent::importer
