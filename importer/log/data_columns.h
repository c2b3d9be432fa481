// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The columns of numbers in a table: their first and last row, and the texts above, beside and behind them.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "importer/log/column_words.h"
#include "importer/log/table.h"

namespace detent::importer {

/// The quantity a column measures, by its words.
enum class ColumnQuantity {
  none,
  displacement,
  displacementWeak,
  force,
  forceWeak,
  time,
  index,
  cycle,
  contact,
  other
};

struct DataColumn {
  std::size_t index = 0;  ///< in the table, from 0
  std::string title;      ///< all of its heading, without the unit; may be empty
  std::string group;      ///< a heading above that it shares with columns beside it
  ColumnUnit unit;
  KnownWords words, groupWords;
  ColumnQuantity quantity = ColumnQuantity::none;
  std::vector<double> values;  ///< one for each data row; NaN where there is no number
  std::size_t count = 0;       ///< finite values
  double low = 0, high = 0;
  int decimals = 0;  ///< the finest last digit counts 10^-decimals of its unit
  bool isInteger = false;
  bool isText = false;         ///< words instead of numbers
  bool isUnknownName = false;  ///< its title has words, and no list knows one of them
  bool namesRecord = false;    ///< titled by a condition or a specimen: "85 °C (N)", "0 cycles", "Switch A"
  bool ratioGiven = false;     ///< its unit comes from a line such as "steps_per_mm = 800"

  bool isConstant() const { return !(high > low); }
  /// 1, 2, 3, ...: the number of a row.
  bool countsRows() const {
    constexpr std::size_t fewest = 8;
    return isInteger && count >= fewest && high - low + 1 == static_cast<double>(count) && low <= 1;
  }
  bool has(ColumnWord word) const { return words.has(word) || groupWords.has(word); }
  /// "2 \"Force (N)\"", for messages.
  std::string label() const;
  double displacement = 0, force = 0;  ///< log-likelihood of the role, by title, unit and values
};

/// Takes a unit given by hand for the column's own, whatever the file says.
void giveUnit(DataColumn& column, ColumnUnit unit);

/// An interruption of the data by blank rows or rows without numbers.
struct DataBreak {
  std::size_t row = 0;  ///< the data row after the break
  std::string text;     ///< of the rows between; empty: blank
};

struct DataTable {
  std::vector<DataColumn> columns;
  std::vector<std::size_t> rowOf;  ///< row of the table for each data row
  std::vector<DataBreak> breaks;
  std::vector<std::string> captions;  ///< the lines above the headings
  std::size_t rows() const { return rowOf.size(); }
  long leftOut = 0, firstLeftOutLine = 0;  ///< rows within or behind the data
  std::string firstLeftOutText;
};

/// nullopt: the table holds no two columns of numbers.
std::optional<DataTable> dataIn(const Table& table);

}  // namespace detent::importer
