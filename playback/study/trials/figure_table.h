// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table of figures as data: the results of a study are put into such tables once, and text, CSV, JSON and
// pages are made from them. Any thread.

#include <string>
#include <variant>
#include <vector>

namespace detent::playback {

/// Empty if there is no value; text; a number.
using FigureCell = std::variant<std::monostate, std::string, double>;

struct FigureColumn {
  std::string key;          ///< "threshold", "low_percent": unit in the name; for JSON and CSV
  std::string heading;      ///< "threshold, %"; for people
  int decimals = 0;         ///< decimals of numbers shown to people; files contain all digits
  std::string description;  ///< one clause
};

struct FigureTable {
  std::string key;    ///< "thresholds"
  std::string title;  ///< "Thresholds of each participant"
  std::string note;   ///< information needed to read the table; may be empty
  std::vector<FigureColumn> columns;
  std::vector<std::vector<FigureCell>> rows;  ///< each as long as `columns`
};

/// Aligned columns under the title, at most 80 characters wide if possible: values common to many rows are
/// then printed above them.
std::string tableText(const FigureTable& table);
/// A section of a page.
std::string tableMarkup(const FigureTable& table);
/// {"key", "title", "note", "columns": [{"key", "heading", "description"}], "rows": [{key: value or null}]}
std::string tableJson(const FigureTable& table);

/// Number of characters, not bytes.
std::size_t widthOf(const std::string& text);
/// Lines of at most 80 characters, broken at blanks; the first begins with `begin`, the others are indented
/// equally.
std::string wrapped(const std::string& words, const std::string& begin);

}  // namespace detent::playback
