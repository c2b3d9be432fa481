// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/sheet_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/number_table.h"
#include "model/text.h"

namespace detent::importer {
namespace {

constexpr std::size_t mostColumns = 256, mostRows = std::size_t{1} << 20;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Cell {
  double value = none;
  std::string text;
};
using Row = std::vector<Cell>;

/// An attribute of a tag, undecoded; empty if it has none of that name.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const std::size_t from = at + name.size();
    if (tag.substr(from, 2) != "=\"" || at == 0 || !isBlank(tag[at - 1])) continue;
    const std::size_t to = tag.find('"', from + 2);
    return to == std::string_view::npos ? std::string_view() : tag.substr(from + 2, to - from - 2);
  }
  return {};
}

std::size_t repeats(std::string_view tag, std::string_view name, std::size_t most) {
  const auto count = finiteNumberFrom(attribute(tag, name));
  return count && *count >= 1 ? static_cast<std::size_t>(std::min(*count, double(most))) : 1;
}

/// Text between tags with the five references of XML resolved.
void appendText(std::string& text, std::string_view raw) {
  constexpr std::pair<std::string_view, char> references[] = {
      {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
  constexpr std::size_t longestText = 1000;  // of a heading
  while (!raw.empty() && text.size() < longestText) {
    const auto* reference =
        std::ranges::find_if(references, [&](const auto& each) { return raw.starts_with(each.first); });
    if (reference != std::end(references)) {
      text += reference->second;
      raw.remove_prefix(reference->first.size());
    } else {
      text += raw.front();
      raw.remove_prefix(1);
    }
  }
}

/// Rows of the first table, one after the other.
class RowReader {
 public:
  explicit RowReader(std::string_view xml) : rest_(xml) {
    const std::size_t table = rest_.find("<table:table ");
    rest_ = table == std::string_view::npos ? std::string_view() : rest_.substr(table);
    rest_ = rest_.substr(0, rest_.find("</table:table>"));
  }

  /// The next row and how often it repeats; false behind the last.
  bool next(Row& row, std::size_t& times) {
    row.clear();
    const std::size_t from = rest_.find("<table:table-row");
    if (from == std::string_view::npos) return false;
    rest_.remove_prefix(from);
    const std::size_t end = rest_.find('>');
    if (end == std::string_view::npos) return false;
    const std::string_view tag = rest_.substr(0, end);
    times = repeats(tag, "table:number-rows-repeated", mostRows);
    rest_.remove_prefix(end + 1);
    if (tag.ends_with('/')) return true;
    const std::size_t close = std::min(rest_.find("</table:table-row>"), rest_.size());
    readCells(rest_.substr(0, close), row);
    rest_.remove_prefix(close);
    return true;
  }

 private:
  static void readCells(std::string_view xml, Row& row) {
    Cell cell;
    std::size_t times = 0;  // of the cell being read
    const auto finish = [&] {
      for (; times > 0 && row.size() < mostColumns; --times) row.push_back(cell);
      cell = {}, times = 0;
    };
    while (!xml.empty()) {
      const std::size_t open = std::min(xml.find('<'), xml.size());
      if (times > 0) appendText(cell.text, xml.substr(0, open));
      xml.remove_prefix(open);
      const std::size_t end = xml.find('>');
      if (end == std::string_view::npos) break;
      const std::string_view tag = xml.substr(0, end);
      xml.remove_prefix(end + 1);
      if (tag.starts_with("<table:table-cell") || tag.starts_with("<table:covered-table-cell")) {
        finish();
        times = repeats(tag, "table:number-columns-repeated", mostColumns);
        cell.value = finiteNumberFrom(attribute(tag, "office:value")).value_or(none);
        if (tag.ends_with('/')) finish();
      } else if (tag.starts_with("</table:table-cell") || tag.starts_with("</table:covered-table-cell")) {
        finish();
      }
    }
    finish();
    while (!row.empty() && std::isnan(row.back().value) && row.back().text.empty()) row.pop_back();
  }

  std::string_view rest_;
};

/// Three numbers or more, not more texts than numbers, and no word of a force: headings may have results of the measurement beside them.
bool isOfNumbers(const Row& row) {
  constexpr int leastNumbers = 3;
  int numbers = 0, texts = 0;
  for (const Cell& cell : row) {
    if (!std::isnan(cell.value))
      ++numbers;
    else if (lowered(cell.text).find("force") != std::string::npos)
      return false;
    else if (!cell.text.empty())
      ++texts;
  }
  return numbers >= leastNumbers && numbers >= texts;
}

std::string cellText(const Row& row, std::size_t column) {
  return column < row.size() ? std::string(trimmed(row[column].text)) : std::string();
}

std::vector<SheetColumn> headed(const std::vector<Row>& above, std::size_t width) {
  std::vector<SheetColumn> columns(width);
  std::string title;
  for (std::size_t i = 0; i < width; ++i) {
    if (above.size() > 1 && !cellText(above[above.size() - 2], i).empty())
      title = cellText(above[above.size() - 2], i);
    columns[i].title = title;
    if (!above.empty()) columns[i].heading = cellText(above.back(), i);
  }
  return columns;
}

}  // namespace

Result<std::vector<SheetColumn>> sheetColumns(std::string_view xml, const std::string& subject) {
  std::vector<Row> above;
  std::vector<SheetColumn> columns;
  RowReader reader(xml);
  Row row;
  std::size_t times = 0, rows = 0;
  while (rows < mostRows && reader.next(row, times)) {
    if (columns.empty()) {
      if (!isOfNumbers(row)) {
        if (!row.empty()) above.push_back(row);
        if (above.size() > 8) above.erase(above.begin());
        continue;
      }
      std::size_t width = row.size();
      for (const Row& each : above) width = std::max(width, each.size());
      columns = headed(above, width);
    }
    if (row.empty()) continue;
    for (; times > 0 && rows < mostRows; --times, ++rows)
      for (std::size_t i = 0; i < columns.size(); ++i)
        columns[i].values.push_back(i < row.size() ? row[i].value : none);
  }
  if (columns.empty())
    return Failure{FailureCode::noForceGraph,
                   subject,
                   {},
                   Message("the sheet holds no table of numbers"),
                   Message("Give a sheet with a column of displacement and one of force")};
  return columns;
}

}  // namespace detent::importer
