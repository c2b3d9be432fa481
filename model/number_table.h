// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Number tables as text: a header, then rows of comma-separated fields.

#include <cstddef>
#include <deque>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace detent {

/// Reads the programs' own tables row by row; skips blank lines, lines that begin with #, and a byte order
/// mark. Line ends are LF or CRLF. Fields may be quoted (RFC 4180). Drops a first column without a name,
/// where R's write.csv and pandas' to_csv number the rows. The text must outlive this object.
class NumberTable {
 public:
  explicit NumberTable(std::string_view text);

  /// Advances to the next row; returns false after the last one.
  bool next();
  std::string_view line() const { return line_; }
  const std::vector<std::string_view>& fields() const { return fields_; }  ///< valid until the next row
  std::size_t number() const { return number_; }  ///< number of the row's first line in the text, from 1
  /// "line 3", with a remark if the row's quotation marks do not match.
  std::string place() const;
  /// Returns true if the row consists of exactly these fields.
  bool is(std::initializer_list<std::string_view> fields) const;
  /// Indices of the columns with these names; nullopt if one is missing.
  std::optional<std::vector<std::size_t>> columns(const std::vector<std::string_view>& names) const;
  /// A field of this line as a finite number; nullopt if it is none.
  std::optional<double> finite(std::size_t field) const;

 private:
  bool splitQuoted();

  std::string_view rest_, line_;
  std::vector<std::string_view> fields_;
  std::deque<std::string> unescaped_;  ///< fields that contained doubled quotation marks
  std::size_t number_ = 0, lines_ = 0;
  bool begun_ = false, rowNames_ = false, badQuotes_ = false;
};

/// A complete field as a number with a decimal point, independent of the locale. Accepts "nan" and "inf";
/// overflow gives infinity.
std::optional<double> numberFrom(std::string_view field);
/// Like numberFrom, for finite numbers only.
std::optional<double> finiteNumberFrom(std::string_view field);

/// Returns the fewest digits that read back as the same number, without an exponent below 1e16.
std::string shortestText(double value);

/// Returns the quoted beginning of a text, for messages.
std::string quotedBegin(std::string_view text);

/// Reads a regular file. Failure unreadableInput: it cannot be read, or is larger than `most_bytes`.
Result<std::string> readTable(const std::string& file, std::size_t most_bytes, const Remedies& remedies);

}  // namespace detent
