// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A spreadsheet's table as columns of numbers under their headings, as curve meters' sheets have them.

#include <string>
#include <vector>

#include "importer/log/table.h"

namespace detent::importer {

struct SheetColumn {
  /// Of a two-line heading what stands above, carried to the right over the columns it spans; empty with one line.
  std::string title;
  std::string heading;         ///< the line just above the numbers
  std::vector<double> values;  ///< NaN where a cell holds no number
};

/// Columns of a sheet; none where no row has three numbers or more, and no fewer numbers than texts. The heading is what
/// stands above the first such row.
std::vector<SheetColumn> sheetColumns(const Table& sheet);

}  // namespace detent::importer
