// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/figure_table.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/markup.h"
#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longestLine = 80;

bool isNumber(const FigureCell& cell) { return std::holds_alternative<double>(cell); }

std::string shown(const FigureCell& cell, const FigureColumn& column, const char* nothing) {
  if (const auto* words = std::get_if<std::string>(&cell)) return *words;
  if (!isNumber(cell)) return nothing;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", column.decimals, std::get<double>(cell));
  return text;
}

/// Returns true if a column contains text, which is aligned to the left.
bool ofWords(const FigureTable& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<FigureCell>& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

/// The headings, then every row in the form shown to people.
std::vector<std::vector<std::string>> linesOf(const FigureTable& table) {
  std::vector<std::vector<std::string>> lines(table.rows.size() + 1);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    lines[0].push_back(table.columns[c].heading);
    for (std::size_t r = 0; r < table.rows.size(); ++r)
      lines[r + 1].push_back(shown(table.rows[r][c], table.columns[c], "-"));
  }
  return lines;
}

/// Width of each column of lines.
std::vector<std::size_t> widthsOf(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines[0].size(), 0);
  for (const std::vector<std::string>& line : lines)
    for (std::size_t c = 0; c < widths.size(); ++c) widths[c] = std::max(widths[c], widthOf(line[c]));
  return widths;
}

std::size_t wholeWidth(const std::vector<std::size_t>& widths, const std::vector<std::size_t>& columns) {
  std::size_t width = 1;
  for (const std::size_t c : columns) width += 1 + widths[c];
  return width;
}

/// The text column that changes least often: it can be printed above the rows that share it. None if every
/// column changes in every row.
std::optional<std::size_t> rarestChange(const FigureTable& table, const std::vector<std::size_t>& columns) {
  std::optional<std::size_t> rarest;
  std::size_t least = table.rows.size();
  for (const std::size_t c : columns) {
    if (!ofWords(table, c)) continue;
    std::size_t changes = 1;
    for (std::size_t r = 1; r < table.rows.size(); ++r)
      changes += table.rows[r][c] != table.rows[r - 1][c] ? 1 : 0;
    if (changes < least) rarest = c, least = changes;
  }
  return rarest;
}

}  // namespace

std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string wrapped(const std::string& words, const std::string& begin) {
  const std::string indent(widthOf(begin), ' ');
  std::string text, line = begin;
  bool empty = true;
  std::istringstream in(words);
  for (std::string word; in >> word; empty = false) {
    if (!empty && widthOf(line) + 1 + widthOf(word) > longestLine) {
      text += line + "\n";
      line = indent;
      empty = true;
    }
    line += (empty ? "" : " ") + word;
  }
  return empty ? text : text + line + "\n";
}

std::string tableText(const FigureTable& table) {
  const std::vector<std::vector<std::string>> lines = linesOf(table);
  const std::vector<std::size_t> widths = widthsOf(lines);
  std::vector<std::size_t> beside, above;
  for (std::size_t c = 0; c < table.columns.size(); ++c) beside.push_back(c);
  while (wholeWidth(widths, beside) > longestLine) {
    const std::optional<std::size_t> moved = rarestChange(table, beside);
    if (!moved) break;
    above.push_back(*moved);
    std::erase(beside, *moved);
  }
  std::string text = table.title + "\n", group;
  for (std::size_t r = 0; r < lines.size(); ++r) {
    std::string now;
    for (const std::size_t c : above) now += (now.empty() ? "" : ", ") + lines[r][c];
    if (r > 0 && now != group) text += "  " + (group = now) + ":\n";
    std::string row = " ";
    for (const std::size_t c : beside) {
      const std::string space(widths[c] - widthOf(lines[r][c]), ' ');
      row += " " + (ofWords(table, c) ? lines[r][c] + space : space + lines[r][c]);
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text + wrapped(table.note, "  ");
}

std::string tableMarkup(const FigureTable& table) {
  std::string text = "<section><h2>" + escapedForMarkup(table.title) + "</h2>\n<table><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    text += std::string(ofWords(table, c) ? "<th class=\"words\"" : "<th") + " title=\"" +
            escapedForMarkup(table.columns[c].description) + "\">" +
            escapedForMarkup(table.columns[c].heading) + "</th>";
  text += "</tr>\n";
  for (const std::vector<FigureCell>& row : table.rows) {
    text += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      text += (ofWords(table, c) ? "<td class=\"words\">" : "<td>") +
              escapedForMarkup(shown(row[c], table.columns[c], "–")) + "</td>";
    text += "</tr>\n";
  }
  if (!table.note.empty()) text += "<caption>" + escapedForMarkup(table.note) + "</caption>";
  return text + "</table></section>\n";
}

std::string tableJson(const FigureTable& table) {
  Json columns = Json::array(), rows = Json::array();
  for (const FigureColumn& column : table.columns)
    columns.push_back(
        {{"key", column.key}, {"heading", column.heading}, {"description", column.description}});
  for (const std::vector<FigureCell>& row : table.rows) {
    Json object = Json::object();
    for (std::size_t c = 0; c < row.size(); ++c) {
      Json& value = object[table.columns[c].key];
      if (const auto* words = std::get_if<std::string>(&row[c]))
        value = *words;
      else if (isNumber(row[c]))
        value = std::get<double>(row[c]);
    }
    rows.push_back(object);
  }
  return jsonText(Json{{"key", table.key},
                       {"title", table.title},
                       {"note", table.note},
                       {"columns", columns},
                       {"rows", rows}});
}

}  // namespace detent::playback
