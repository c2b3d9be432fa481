// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Number tables as text: a header, then rows of comma-separated fields.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace detent {

/// Iterates over the non-empty lines of a table; skips blank lines, lines that begin with #, and a byte order
/// mark. Line ends are LF or CRLF. The text must outlive this object.
class NumberTable {
 public:
  explicit NumberTable(std::string_view text);

  /// Advances to the next line; returns false after the last one.
  bool next();
  std::string_view line() const { return line_; }
  const std::vector<std::string_view>& fields() const { return fields_; }
  std::size_t number() const { return number_; }  ///< line number in the text, from 1
  std::string place() const { return "line " + std::to_string(number_); }
  /// Indices of the columns with these names; nullopt if one is missing.
  std::optional<std::vector<std::size_t>> columns(const std::vector<std::string_view>& names) const;
  /// A field of this line as a finite number; nullopt if it is none.
  std::optional<double> finite(std::size_t field) const;

 private:
  std::string_view rest_, line_;
  std::vector<std::string_view> fields_;
  std::size_t number_ = 0;
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
