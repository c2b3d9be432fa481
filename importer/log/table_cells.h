// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a table of numbers is written: what separates cells, what the decimal sign is.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace detent::importer {

struct TableFormat {
  char delimiter = ',';    ///< ',', ';', '\t', '|', or ' ' for any run of blanks
  char decimalSign = '.';  ///< '.' or ','
};

/// A cell that starts with a number. `rest` is what follows it ("gf" in "12.5 gf"), trimmed.
struct NumberCell {
  double value = 0;
  std::string_view rest;
};

/// Blanks and one pair of quotes taken off.
std::string_view trimmedCell(std::string_view cell);

/// Cells of a line, trimmed; the views point into the line. Delimiters inside quotes do not count.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

/// The number a trimmed cell starts with; nullopt if it does not start with one. May be NaN or infinite.
std::optional<NumberCell> numberIn(std::string_view cell, char decimalSign);

/// A cell that is a number and nothing else but perhaps a unit.
std::optional<double> wholeNumberIn(std::string_view cell, char decimalSign);

/// The format that reads most of the lines as rows of numbers.
TableFormat formatOf(const std::vector<std::string>& lines);

}  // namespace detent::importer
