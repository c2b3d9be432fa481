// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tables of numbers as text: a header, then rows of fields between commas.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace detent {

/// Walks through the lines that hold something: blank ones and those that begin with # are passed over, as is a byte order mark.
/// Line ends are LF or CRLF. The text has to outlive it.
class NumberTable {
 public:
  explicit NumberTable(std::string_view text);

  /// The next line; false behind the last one.
  bool next();
  std::string_view line() const { return line_; }
  const std::vector<std::string_view>& fields() const { return fields_; }
  std::size_t number() const { return number_; }  ///< of the line in the text, from 1
  std::string place() const { return "line " + std::to_string(number_); }
  /// Where columns of these names stand in this line; empty where one is missing.
  std::optional<std::vector<std::size_t>> columns(const std::vector<std::string_view>& names) const;
  /// A field of this line as a finite number; empty where there is none.
  std::optional<double> finite(std::size_t field) const;

 private:
  std::string_view rest_, line_;
  std::vector<std::string_view> fields_;
  std::size_t number_ = 0;
};

/// A whole field as a number, by a decimal point in every locale; "nan" and "inf" are numbers here, and so is what is too large
/// (infinity).
std::optional<double> numberFrom(std::string_view field);
/// The same, where only finite numbers mean anything.
std::optional<double> finiteNumberFrom(std::string_view field);

/// The fewest digits that read back as the same number, without an exponent below 1e16.
std::string shortestText(double value);

/// The beginning of a text between quotes, for messages.
std::string quotedBegin(std::string_view text);

/// The whole of a regular file. Failure unreadableInput: it cannot be read, or is larger than `most_bytes`; says what to give instead.
Result<std::string> readTable(const std::string& file, std::size_t most_bytes, const Remedies& remedies);

}  // namespace detent
