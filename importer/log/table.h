// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file as rows of cells, for all its forms: delimited text in any encoding, a spreadsheet, JSON records.

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "importer/page/progress.h"
#include "model/result.h"

namespace detent::importer {

/// Number style of a whole file.
struct NumberStyle {
  char decimalSign = '.';  ///< '.' or ','
  char thousands = 0;      ///< ',', '.', ' ' or '\''; 0: none
  bool operator==(const NumberStyle&) const = default;
};

/// A cell that starts with a number. `rest` is what follows it ("gf" in "12.5 gf"), trimmed.
struct NumberCell {
  double value = 0;
  std::string_view rest;
  int decimals = 0;  ///< its last digit counts 10^-decimals: 2 in "0.25", 5 in "2.5e-4", -2 in "1.5e3"
};

/// The number a trimmed cell starts with; nullopt for dates, times and words. May be NaN or infinite.
std::optional<NumberCell> numberIn(std::string_view cell, const NumberStyle& style);

/// Cells in rows; the views point into the table's own text. Copies share it.
class Table {
 public:
  std::size_t rows() const { return starts_.size() - 1; }
  std::size_t cells(std::size_t row) const { return starts_[row + 1] - starts_[row]; }
  /// Trimmed and without quotes; empty beyond the end of a row.
  std::string_view cell(std::size_t row, std::size_t column) const {
    return column < cells(row) ? cells_[starts_[row] + column] : std::string_view();
  }
  long line(std::size_t row) const { return lines_[row]; }  ///< in the file, from 1
  std::optional<NumberCell> number(std::size_t row, std::size_t column) const {
    return numberIn(cell(row, column), style);
  }

  void beginRow(long line);
  void addCell(std::string_view text) { cells_.push_back(text), ++starts_.back(); }
  void addOwnCell(std::string text) { addCell(text_->emplace_back(std::move(text))); }
  /// Text that cells point into.
  const std::string& keep(std::string text) { return text_->emplace_back(std::move(text)); }
  Table transposed() const;

  NumberStyle style;
  std::string name;  ///< name of the sheet; empty for a text file

 private:
  std::shared_ptr<std::deque<std::string>> text_ = std::make_shared<std::deque<std::string>>();
  std::vector<std::string_view> cells_;
  std::vector<std::size_t> starts_{0};
  std::vector<long> lines_;
};

/// Delimited text as a table. The delimiter and the number style are those that read most of the file as rows
/// of numbers. Failure: cancelled; unreadableInput: a line longer than 1 MB.
Result<Table> tableOfText(std::string text, const std::string& subject, const Progress& progress);

/// The non-empty sheets of an xlsx or OpenDocument spreadsheet. Formulas have the value that was saved with
/// them; cells of uncalculated formulas are empty. Failure unreadableInput: damaged, encrypted, or larger
/// than 64 MB when unpacked. Entities are not expanded.
Result<std::vector<Table>> tablesOfSpreadsheet(const std::string& bytes, const std::string& subject);

/// Number of formulas of an xlsx file that no program has calculated.
std::size_t uncalculatedFormulas(const std::string& bytes);

/// Kind of a file's content, by its first bytes.
enum class FileContent { text, spreadsheet, oldSpreadsheet, tar };
FileContent contentOf(std::string_view bytes);

/// The text of UTF-8, UTF-16 (with a byte order mark, or recognised by its zero bytes) or, if it is not valid
/// UTF-8, a national charset, converted to UTF-8. nullopt: not text.
std::optional<std::string> utf8From(std::string bytes);

/// Failures of a file.
inline Failure unreadableFile(const std::string& subject, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, subject, {}, std::move(problem), std::move(remedies)};
}
inline Failure noForceLog(const std::string& subject, Message problem, Remedies remedies = {}) {
  return {FailureCode::noForceGraph, subject, {}, std::move(problem), std::move(remedies)};
}

}  // namespace detent::importer
