// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/study/trials/figure_table.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/markup.h"
#include "playback/measurement/exact_number.h"

namespace detent::playback {

namespace {

using Json = nlohmann::ordered_json;

bool isNumber(const FigureCell& cell) { return std::holds_alternative<double>(cell); }

std::string shown(const FigureCell& cell, const FigureColumn& column, const char* nothing) {
  if (const auto* words = std::get_if<std::string>(&cell)) return *words;
  if (!isNumber(cell)) return nothing;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", column.decimals, std::get<double>(cell));
  return text;
}

/// Whether a column holds words, which stand at the left.
bool ofWords(const FigureTable& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<FigureCell>& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

}  // namespace

std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string wrapped(const std::string& words, const std::string& begin) {
  constexpr std::size_t longest = 80;
  const std::string indent(widthOf(begin), ' ');
  std::string text, line = begin;
  bool empty = true;
  std::istringstream in(words);
  for (std::string word; in >> word; empty = false) {
    if (!empty && widthOf(line) + 1 + widthOf(word) > longest) {
      text += line + "\n";
      line = indent;
      empty = true;
    }
    line += (empty ? "" : " ") + word;
  }
  return empty ? text : text + line + "\n";
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string tableText(const FigureTable& table) {
  std::vector<std::vector<std::string>> lines(table.rows.size() + 1);
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    lines[0].push_back(table.columns[c].heading);
    for (std::size_t r = 0; r < table.rows.size(); ++r)
      lines[r + 1].push_back(shown(table.rows[r][c], table.columns[c], "-"));
    std::size_t width = 0;
    for (const std::vector<std::string>& line : lines) width = std::max(width, widthOf(line[c]));
    widths.push_back(width);
  }
  std::string text = table.title + "\n";
  for (const std::vector<std::string>& line : lines) {
    std::string row = " ";
    for (std::size_t c = 0; c < line.size(); ++c) {
      const std::string space(widths[c] - widthOf(line[c]), ' ');
      row += " " + (ofWords(table, c) ? line[c] + space : space + line[c]);
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
