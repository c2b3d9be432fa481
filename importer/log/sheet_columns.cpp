// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/sheet_columns.h"

#include <cmath>
#include <limits>

#include "model/text.h"

namespace detent::importer {
namespace {

/// Three numbers or more, not more texts than numbers, and no word of a force: headings may have results of the measurement beside them.
bool isOfNumbers(const Table& sheet, std::size_t row) {
  constexpr int leastNumbers = 3;
  int numbers = 0, texts = 0;
  for (std::size_t c = 0; c < sheet.cells(row); ++c) {
    const std::string_view cell = sheet.cell(row, c);
    if (cell.empty()) continue;
    if (sheet.number(row, c))
      ++numbers;
    else if (lowered(cell).find("force") != std::string::npos)
      return false;
    else
      ++texts;
  }
  return numbers >= leastNumbers && numbers >= texts;
}

std::vector<SheetColumn> headed(const Table& sheet, const std::vector<std::size_t>& above,
                                std::size_t width) {
  std::vector<SheetColumn> columns(width);
  std::string title;
  for (std::size_t i = 0; i < width; ++i) {
    if (above.size() > 1 && !sheet.cell(above[above.size() - 2], i).empty())
      title = std::string(sheet.cell(above[above.size() - 2], i));
    columns[i].title = title;
    if (!above.empty()) columns[i].heading = std::string(sheet.cell(above.back(), i));
  }
  return columns;
}

}  // namespace

std::vector<SheetColumn> sheetColumns(const Table& sheet) {
  std::vector<std::size_t> above;
  std::vector<SheetColumn> columns;
  for (std::size_t row = 0; row < sheet.rows(); ++row) {
    const std::size_t width = sheet.cells(row);
    if (columns.empty()) {
      if (!isOfNumbers(sheet, row)) {
        if (width > 0) above.push_back(row);
        continue;
      }
      std::size_t widest = width;
      for (const std::size_t each : above) widest = std::max(widest, sheet.cells(each));
      columns = headed(sheet, above, widest);
    }
    if (width == 0) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto number = sheet.number(row, i);
      columns[i].values.push_back(number ? number->value : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return columns;
}

}  // namespace detent::importer
