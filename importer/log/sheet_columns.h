// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A spreadsheet's first table as columns of numbers under their headings.

#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace detent::importer {

struct SheetColumn {
  /// Of a two-line heading what stands above, carried to the right over the columns it spans; empty with one line.
  std::string title;
  std::string heading;         ///< the line just above the numbers
  std::vector<double> values;  ///< NaN where a cell holds no number
};

/// Columns of the first table of an OpenDocument spreadsheet, from the XML in its archive. The heading is what stands above the
/// first row of three numbers or more, and no fewer numbers than texts. What repeats is bounded: at most 256 columns and 2^20 rows. Failure noForceGraph about `subject`:
/// no such row. Any thread.
Result<std::vector<SheetColumn>> sheetColumns(std::string_view xml, const std::string& subject);

}  // namespace detent::importer
