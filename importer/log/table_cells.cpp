// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/table_cells.h"

#include <algorithm>
#include <charconv>

namespace detent::importer {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// How much of the lines a format explains: shares of cells that are whole numbers, over lines with at least
/// two of them.
double explainedBy(const std::vector<std::string>& lines, TableFormat format) {
  double sum = 0;
  std::vector<std::string_view> cells;
  for (const std::string& line : lines) {
    splitCells(line, format.delimiter, cells);
    int numbers = 0, filled = 0;
    for (std::string_view cell : cells) {
      if (cell.empty()) continue;
      ++filled;
      if (wholeNumberIn(cell, format.decimalSign)) ++numbers;
    }
    if (numbers >= 2) sum += static_cast<double>(numbers) / filled;
  }
  return sum;
}

}  // namespace

std::string_view trimmedCell(std::string_view cell) {
  const auto strip = [&] {
    while (!cell.empty() && isBlank(cell.front())) cell.remove_prefix(1);
    while (!cell.empty() && isBlank(cell.back())) cell.remove_suffix(1);
  };
  strip();
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
  strip();
  return cell;
}

void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  cells.clear();
  if (delimiter == ' ') {
    for (std::size_t i = 0; i < line.size();) {
      while (i < line.size() && isBlank(line[i])) ++i;
      std::size_t end = i;
      while (end < line.size() && !isBlank(line[end])) ++end;
      if (end > i) cells.push_back(trimmedCell(line.substr(i, end - i)));
      i = end;
    }
    return;
  }
  std::size_t start = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != delimiter)) continue;
    cells.push_back(trimmedCell(line.substr(start, i - start)));
    start = i + 1;
  }
}

std::optional<NumberCell> numberIn(std::string_view cell, char decimalSign) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  // U+2212, the minus sign of typeset tables.
  char buffer[64];
  std::size_t offset = 0, length = 0;
  const char *first = cell.data(), *last = cell.data() + cell.size();
  if (cell.starts_with("\xE2\x88\x92")) {
    buffer[length++] = '-';
    offset = 3;
  }
  if (decimalSign != '.' || offset > 0) {
    for (std::size_t i = offset; i < cell.size() && length < sizeof buffer; ++i) {
      if (decimalSign == ',' && cell[i] == '.') break;
      buffer[length++] = cell[i] == decimalSign ? '.' : cell[i];
    }
    first = buffer;
    last = buffer + length;
  }
  NumberCell number;
  const auto [end, error] = std::from_chars(first, last, number.value);
  if (end == first || error == std::errc::invalid_argument) return std::nullopt;
  const std::size_t used = static_cast<std::size_t>(end - first);
  const std::size_t usedOfCell = offset > 0 ? used - 1 + offset : used;
  number.rest = trimmedCell(cell.substr(std::min(usedOfCell, cell.size())));
  return number;
}

std::optional<double> wholeNumberIn(std::string_view cell, char decimalSign) {
  const auto number = numberIn(cell, decimalSign);
  if (!number) return std::nullopt;
  // "1,5" under a decimal point, "12:30" and "2024-05-01" start with a number but are none.
  const auto startsUnit = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || (byte >= 'A' && byte <= 'Z') || (byte >= 'a' && byte <= 'z') || byte == '%';
  };
  if (!number->rest.empty() && !startsUnit(number->rest.front())) return std::nullopt;
  return number->value;
}

TableFormat formatOf(const std::vector<std::string>& lines) {
  // In this order ties are settled: "1;2" reads the same with either decimal sign.
  constexpr TableFormat formats[] = {{'\t', '.'}, {';', '.'}, {',', '.'}, {'|', '.'}, {' ', '.'},
                                     {'\t', ','}, {';', ','}, {'|', ','}, {' ', ','}, {',', ','}};
  TableFormat best = formats[2];
  double most = 0;
  for (const TableFormat& format : formats) {
    const double explained = explainedBy(lines, format);
    if (explained > most + 1e-9) most = explained, best = format;
  }
  return best;
}

}  // namespace detent::importer
