// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Button states side by side, as rows of one figure each.

#include <optional>
#include <QString>
#include <vector>

#include "editor/document/display_units.h"
#include "model/button.h"
#include "model/compare.h"

namespace detent::editor {

enum class Measure { length, force, slope, work, share, count };

/// One figure of all buttons; empty for a button without it. mm, N, N/mm, mJ, a share, or a count.
struct DifferenceRow {
  QString name;
  Measure measure = Measure::length;
  std::vector<std::optional<double>> values;  ///< in the order of the states
};

/// Travel, forces, tactile points (in the order travelled, as many as the richest one has), slopes,
/// bottom-out, work, operating and reset point. Rows that none has are left out.
std::vector<DifferenceRow> differencesOf(const std::vector<const ButtonState*>& states);

/// Text of a table cell, without the unit; "–" for a missing value.
QString shownValue(std::optional<double> value, Measure measure, const DisplayUnits& units);
/// Value `other` of the row minus the first, with its sign; "–" unless both are there.
QString shownDifference(const DifferenceRow& row, std::size_t other, const DisplayUnits& units);
/// Unit of a measure: "cN", "cN/mm", "mJ", "%"; empty for counts.
QString shownUnit(Measure measure, const DisplayUnits& units);

/// The distance of two curves in one line, in the shown units.
QString shownDistance(const GraphDistance& distance, const DisplayUnits& units);

}  // namespace detent::editor
