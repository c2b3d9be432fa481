// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the columns of a force meter's table are: displacement, force, which stroke; their units.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "importer/log/table_cells.h"
#include "model/stroke_curve.h"
#include "model/units.h"

namespace detent::importer {

/// One pair of columns; `stroke` where the header names it.
struct ColumnPair {
  std::size_t displacement = 0, force = 0;
  std::optional<Stroke> stroke;
};

struct LogColumns {
  std::vector<ColumnPair> pairs;     ///< 1 or 2
  std::optional<std::size_t> label;  ///< column whose cells say press or release
  std::optional<std::size_t> time;   ///< numbers under a title that says time
  double secondsPerTime = 1;         ///< of its unit; a title without one means seconds
  std::optional<LengthUnit> xUnit;   ///< as printed; nullopt: none found
  std::optional<ForceUnit> yUnit;
  std::string header;        ///< the header line as found, "" if there is none
  std::size_t firstRow = 0;  ///< index of the first row of numbers in the lines given
};

/// Which stroke a word of a header or label cell means (English, German, Chinese, Japanese).
std::optional<Stroke> strokeNamed(std::string_view text);

/// Columns from the first lines of a file. nullopt: no two columns of numbers.
std::optional<LogColumns> columnsOf(const std::vector<std::string>& lines, TableFormat format);

}  // namespace detent::importer
