// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A table of figures as data: what a study found is put into such tables once, and text, CSV, JSON and pages
// read them all alike. Any thread.

#include <string>
#include <variant>
#include <vector>

namespace detent::playback {

/// Empty where there is nothing to say; words; a number.
using FigureCell = std::variant<std::monostate, std::string, double>;

struct FigureColumn {
  std::string key;          ///< "threshold", "low_percent": unit in the name; for JSON and CSV
  std::string heading;      ///< "threshold, %"; for people
  int decimals = 0;         ///< of numbers as people read them; files hold them whole
  std::string description;  ///< one clause
};

struct FigureTable {
  std::string key;    ///< "thresholds"
  std::string title;  ///< "Thresholds of each participant"
  std::string note;   ///< what must be known to read it; may be empty
  std::vector<FigureColumn> columns;
  std::vector<std::vector<FigureCell>> rows;  ///< each as long as `columns`
};

/// Aligned columns under the title, 80 letters wide where that can be: what is the same for many rows then
/// stands above them.
std::string tableText(const FigureTable& table);
/// A section of a page.
std::string tableMarkup(const FigureTable& table);
/// {"key", "title", "note", "columns": [{"key", "heading", "description"}], "rows": [{key: value or null}]}
std::string tableJson(const FigureTable& table);

/// Letters, not bytes.
std::size_t widthOf(const std::string& text);
/// Lines of at most 80 letters, broken at blanks; the first begins with `begin`, the others are indented as
/// deep.
std::string wrapped(const std::string& words, const std::string& begin);

}  // namespace detent::playback
