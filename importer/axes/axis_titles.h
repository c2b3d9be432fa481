// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Axis titles: where they stand, what they say, which unit they name.

#include <optional>
#include <string>

#include "importer/axes/axis_labels.h"
#include "importer/lexicon/printed_unit.h"

namespace detent::importer {

template <class Unit>
struct AxisTitle {
  std::optional<PrintedUnit<Unit>> unit;
  std::string text;  ///< the line that names the unit, or else the nearest one
  std::string
      other;  ///< what the nearest line measures instead, as printed: "kPa", "Time"; empty if nothing else
};

/// Below the labels, or at the right end of the axis. The document's own text first; pixels only without it.
AxisTitle<LengthUnit> readXTitle(GraphReading& r, const Box& labels);
/// Left of the labels reading upwards, above the top left corner, or beside the axis' upper end.
AxisTitle<ForceUnit> readYTitle(GraphReading& r, const Box& labels);
/// Right of the labels of a second scale there, and nowhere else.
AxisTitle<ForceUnit> readRightTitle(GraphReading& r, const Box& labels);

}  // namespace detent::importer
