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

/// The quantity that a column measures, according to the words of its title.
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
  std::string title;      ///< whole heading without the unit; may be empty
  std::string group;      ///< heading above the title that neighbouring columns share
  ColumnUnit unit;
  KnownWords words, groupWords;
  ColumnQuantity quantity = ColumnQuantity::none;
  std::vector<double> values;  ///< one for each data row; NaN where there is no number
  std::size_t count = 0;       ///< finite values
  double low = 0, high = 0;
  int decimals = 0;  ///< the last digit of the finest number counts 10^-decimals of the unit
  bool isInteger = false;
  bool isText = false;         ///< true: words, not numbers
  bool isUnknownName = false;  ///< the title has words, but none that the lexicon knows
  bool namesRecord = false;    ///< titled by a condition or a specimen: "85 °C (N)", "0 cycles", "Switch A"
  bool ratioGiven = false;     ///< its unit comes from a line such as "steps_per_mm = 800"

  bool isConstant() const { return !(high > low); }
  /// True for the numbers of rows: 1, 2, 3, ...
  bool countsRows() const {
    constexpr std::size_t fewest = 8;
    return isInteger && count >= fewest && high - low + 1 == static_cast<double>(count) && low <= 1;
  }
  bool has(ColumnWord word) const { return words.has(word) || groupWords.has(word); }
  /// "2 \"Force (N)\"", for messages.
  std::string label() const;
  /// log-likelihood that the column is the displacement, or the force, by its title, unit and values
  double displacement = 0, force = 0;
};

/// Replaces the unit that the file states by one given by hand.
void giveUnit(DataColumn& column, ColumnUnit unit);

/// An interruption of the data by blank rows or rows without numbers.
struct DataBreak {
  std::size_t row = 0;  ///< the data row after the break
  std::string text;     ///< text of the rows between; empty if they are blank
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
