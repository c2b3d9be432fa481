// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/table.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include <iconv.h>

#include "importer/lexicon/letters.h"
#include "importer/log/column_words.h"
#include "model/text.h"

namespace detent::importer {
namespace {

bool isAscii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Number of digits behind the decimal point minus the exponent, for a number that from_chars can read.
int decimalsOf(std::string_view plain) {
  std::size_t e = 0, point = plain.size();
  for (; e < plain.size() && plain[e] != 'e' && plain[e] != 'E'; ++e)
    if (plain[e] == '.') point = e;
  int exponent = 0;
  const bool positive = e + 1 < plain.size() && plain[e + 1] == '+';
  if (e < plain.size())
    std::from_chars(plain.data() + e + (positive ? 2 : 1), plain.data() + plain.size(), exponent);
  return (point < e ? static_cast<int>(e - point - 1) : 0) - exponent;
}

/// Typographic signs and blanks, with the plain ones they replace.
constexpr std::array<std::pair<std::string_view, char>, 8> plainSigns{{{"\xE2\x88\x92", '-'},
                                                                       {"\xE2\x80\x93", '-'},
                                                                       {"\xC2\xA0", ' '},
                                                                       {"\xE2\x80\xAF", ' '},
                                                                       {"\xE2\x80\x89", ' '},
                                                                       {"\xE2\x80\x99", '\''},
                                                                       {"\xEF\xBC\x8C", ','},
                                                                       {"\xEF\xBC\x8E", '.'}}};

char plainSignAt(std::string_view text, std::size_t& length) {
  for (const auto& [spelling, plain] : plainSigns)
    if (text.starts_with(spelling)) return length = spelling.size(), plain;
  return 0;
}

/// Copies the number at a cell's beginning to `plain`, in the form that from_chars reads. Returns the number
/// of bytes that it takes in the cell.
std::size_t plainNumber(std::string_view cell, const NumberStyle& style, std::string& plain) {
  std::size_t at = 0, group = 0;
  bool seenDecimal = false, seenDigit = false, seenExponent = false, seenThousands = false;
  while (at < cell.size()) {
    std::size_t length = 1;
    char c = cell[at];
    if (static_cast<unsigned char>(c) >= 0x80) c = plainSignAt(cell.substr(at), length);
    if (isDigit(c)) {
      plain += c;
      seenDigit = true;
      if (!seenDecimal && !seenExponent) ++group;
    } else if (c == style.decimalSign && !seenDecimal && !seenExponent) {
      plain += '.';
      seenDecimal = true;
    } else if (style.thousands && c == style.thousands && seenDigit && !seenDecimal && !seenExponent) {
      const std::string_view next = cell.substr(at + length, 3);
      const std::size_t firstGroup = seenThousands ? 3 : group;
      if (next.size() < 3 || !std::ranges::all_of(next, isDigit) || firstGroup == 0 || firstGroup > 3 ||
          (!seenThousands && plain[plain.size() - group] == '0'))
        break;
      seenThousands = true, group = 0;
    } else if ((c == '-' || c == '+') && (plain.empty() || plain.back() == 'e')) {
      if (c == '-' || !plain.empty()) plain += c;
    } else if ((c == 'e' || c == 'E') && seenDigit && !seenExponent && at + 1 < cell.size() &&
               (isDigit(cell[at + 1]) || ((cell[at + 1] == '-' || cell[at + 1] == '+') &&
                                          at + 2 < cell.size() && isDigit(cell[at + 2])))) {
      plain += 'e';
      seenExponent = true;
    } else {
      break;
    }
    at += length;
  }
  if (!seenDigit || (seenThousands && group != 3)) return 0;
  return at;
}

}  // namespace

std::optional<NumberCell> numberIn(std::string_view cell, const NumberStyle& style) {
  if (cell.empty()) return {};
  NumberCell number;
  const char first = cell.front();
  // Fast path for the usual case, without a copy.
  if (style.decimalSign == '.' && (isDigit(first) || first == '-')) {
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number.value);
    if (error == std::errc() && end == cell.data() + cell.size()) {
      number.decimals = decimalsOf(cell);
      return number;
    }
  }
  if (!isDigit(first) && first != '-' && first != '+' && first != style.decimalSign &&
      static_cast<unsigned char>(first) < 0x80) {
    const std::string word = cell.size() <= 4 ? lowered(cell) : std::string();
    if (word == "nan" || word == "inf") return NumberCell{std::numeric_limits<double>::quiet_NaN(), {}, 0};
    return {};
  }
  std::string plain;
  const std::size_t length = plainNumber(cell, style, plain);
  if (length == 0) return {};
  number.decimals = decimalsOf(plain);
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), number.value);
  if (error == std::errc::result_out_of_range)
    number.value = std::numeric_limits<double>::infinity();
  else if (error != std::errc() || end != plain.data() + plain.size())
    return {};
  number.rest = trimmed(cell.substr(length));
  if (number.rest.starts_with("\xC2\xA0")) number.rest = trimmed(number.rest.substr(2));
  if (!number.rest.empty()) {
    // More digits or separators follow: a date, a time, a version, or a number in another style.
    const char next = number.rest.front();
    constexpr std::string_view otherStyles = ".,:;-/'|", delimiters = ";\t|";
    if (isDigit(next) || otherStyles.find(next) != std::string_view::npos) return {};
    if (number.rest.find_first_of(delimiters) != std::string_view::npos) return {};
  }
  return number;
}

void Table::beginRow(long line) {
  starts_.push_back(starts_.back());
  lines_.push_back(line);
}

Table Table::transposed() const {
  Table turned;
  turned.text_ = text_;
  turned.style = style, turned.name = name;
  std::size_t most = 0;
  for (std::size_t row = 0; row < rows(); ++row) most = std::max(most, cells(row));
  for (std::size_t column = 0; column < most; ++column) {
    turned.beginRow(static_cast<long>(column) + 1);
    for (std::size_t row = 0; row < rows(); ++row) turned.addCell(cell(row, column));
  }
  return turned;
}

// -- delimited text -----------------------------------------------------------------------------------------

namespace {

constexpr std::size_t longestTextLine_bytes = std::size_t{1} << 20;

std::string_view withoutQuotes(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

/// Splits one logical line from `at` on (quoted fields may contain line breaks) and returns the beginning of
/// the next one. `give` receives each cell unchanged.
template <class Give>
std::size_t splitLine(std::string_view text, std::size_t at, char delimiter, Give give) {
  std::size_t from = at;
  bool quoted = false, started = false;
  const auto endsLine = [&](std::size_t i) { return text[i] == '\n' || text[i] == '\r'; };
  while (true) {
    if (at >= text.size() || (!quoted && endsLine(at))) {
      give(text.substr(from, at - from));
      if (at < text.size()) at += text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n' ? 2 : 1;
      return at;
    }
    const char c = text[at];
    if (c == '"' && (quoted || !started)) {
      // A quotation mark without a closing one means inches; it does not quote the rest of the file.
      if (!quoted) {
        const std::size_t close = text.find('"', at + 1);
        constexpr std::size_t longestField_bytes = 2000;
        quoted = close != std::string_view::npos && close - at < longestField_bytes;
      } else if (at + 1 < text.size() && text[at + 1] == '"') {
        ++at;
      } else {
        quoted = false;
      }
      started = true;
    } else if (!quoted && (delimiter == ' ' ? c == ' ' || c == '\t' : c == delimiter)) {
      give(text.substr(from, at - from));
      if (delimiter == ' ')
        while (at + 1 < text.size() && (text[at + 1] == ' ' || text[at + 1] == '\t')) ++at;
      from = at + 1;
      started = false;
    } else if (!isBlank(c)) {
      started = true;
    }
    ++at;
  }
}

std::size_t lineEnd(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] != '\n' && text[at] != '\r') ++at;
  return at;
}

/// Lines spread over the whole text, blank ones left out.
std::vector<std::string_view> sampledLines(std::string_view text) {
  constexpr std::size_t most = 400;
  const char sign = text.find('\n') != std::string_view::npos ? '\n' : '\r';
  const std::size_t count = static_cast<std::size_t>(std::ranges::count(text, sign)) + 1;
  const std::size_t every = std::max<std::size_t>(1, count / most);
  std::vector<std::string_view> lines;
  std::size_t index = 0;
  for (std::size_t at = 0; at < text.size(); ++index) {
    const std::size_t end = std::min(text.find(sign, at), text.size());
    if (index % every == 0 || index < most / 4) {
      const std::string_view line = text.substr(at, end - at);
      if (!trimmed(line).empty()) lines.push_back(line);
    }
    at = end + 1;
  }
  return lines;
}

/// "11.03.2026", "2026-03-11"
bool isDate(std::string_view cell) {
  for (const char sign : {'.', '-'})
    if (std::ranges::count(cell, sign) == 2 && cell.find(',') == std::string_view::npos &&
        isDigit(cell.front()) && isDigit(cell.back()) && cell.size() >= 8 && cell.size() <= 10)
      return true;
  return false;
}

struct Dialect {
  char delimiter = ',';
  NumberStyle style;
  bool commaComma = false;  ///< the decimal comma is the delimiter as well: "0,0078,0,1062"
  double score = 0;
};

/// Roughness of a column of numbers: the sum of its second differences divided by its range. A number misread
/// by a factor of a thousand increases it.
double roughnessOf(const std::vector<double>& values) {
  if (values.size() < 4) return 0;
  const auto [low, high] = std::ranges::minmax(values);
  if (!(high > low)) return 0;
  double sum = 0;
  for (std::size_t i = 2; i < values.size(); ++i)
    sum += std::abs(values[i] - 2 * values[i - 1] + values[i - 2]);
  return sum / (high - low);
}

/// Scores a dialect on the sampled lines: many rows of numbers, few unreadable digits, smooth columns.
void judge(Dialect& dialect, const std::vector<std::string_view>& lines) {
  std::map<std::size_t, std::vector<double>> columns;
  double rows = 0, junk = 0;
  for (const std::string_view line : lines) {
    std::size_t width = 0, inLine = 0;
    splitLine(line, 0, dialect.delimiter, [&](std::string_view raw) {
      const std::string_view cell = withoutQuotes(raw);
      const std::size_t column = width++;
      if (cell.empty()) return;
      if (const auto number = numberIn(cell, dialect.style); number && std::isfinite(number->value)) {
        ++inLine;
        columns[column].push_back(number->value);
      } else if (isDigit(cell[cell.find_first_not_of("+-") % cell.size()]) && !isDate(cell)) {
        junk += 1;  // begins with a digit, but is no number
      }
    });
    if (inLine >= 2) rows += 1;
  }
  double rough = 0;
  for (const auto& [column, values] : columns) rough += std::min(roughnessOf(values), 50.0);
  const double all = std::max(1.0, static_cast<double>(lines.size()));
  // weights relative to the share of rows that are read
  constexpr double junkWorth = 1.5, roughWorth = 0.01;
  dialect.score = (rows == 0 ? -1 : 0) + (rows - junkWorth * junk) / all - roughWorth * rough;
}

/// Returns true if the comma is both delimiter and decimal sign: each row consists of pairs of cells that are
/// the digits before and behind a decimal comma.
bool isCommaComma(const std::vector<std::string_view>& lines) {
  std::map<std::size_t, std::size_t> widths;
  std::size_t rows = 0;
  for (const std::string_view line : lines) {
    std::vector<std::string_view> cells;
    splitLine(line, 0, ',', [&](std::string_view cell) { cells.push_back(trimmed(cell)); });
    if (cells.size() < 4 || cells.size() % 2) continue;
    bool fits = true;
    for (std::size_t i = 0; i < cells.size() && fits; ++i) {
      std::string_view cell = cells[i];
      if (i % 2 == 0 && cell.starts_with('-')) cell.remove_prefix(1);
      fits = !cell.empty() && std::ranges::all_of(cell, isDigit);
      if (i % 2) fits = fits && cell.size() == cells[1].size() && cell.size() >= 2;
    }
    if (fits) ++rows, ++widths[cells.size()];
  }
  return widths.size() == 1 && rows >= 4 && rows * 10 >= lines.size() * 8;
}

/// Returns true if a sign stands between two digits, so that it may set thousands apart.
bool isBetweenDigits(std::string_view text, char sign) {
  for (std::size_t at = text.find(sign, 1); at < text.size() - 1; at = text.find(sign, at + 1))
    if (isDigit(text[at - 1]) && isDigit(text[at + 1])) return true;
  return false;
}

Dialect dialectOf(std::string_view text) {
  const std::vector<std::string_view> lines = sampledLines(text);
  if (isCommaComma(lines)) return {',', {',', 0}, true, 1};
  Dialect best;
  best.score = -std::numeric_limits<double>::infinity();
  const bool isPlain = isAscii(text);
  const bool hasQuotes = text.find('"') != std::string_view::npos;
  const auto mayGroup = [&](char sign, char delimiter) {
    return !isPlain || (sign == delimiter ? hasQuotes : isBetweenDigits(text, sign));
  };
  // Plainest style first; a later one must read more rows.
  constexpr NumberStyle styles[] = {{'.', 0},   {',', 0},   {'.', ','},  {',', '.'},
                                    {'.', ' '}, {',', ' '}, {'.', '\''}, {',', '\''}};
  for (const char delimiter : {',', ';', '\t', '|', ' '})
    for (const NumberStyle& style : styles) {
      if (delimiter == ' ' && style.thousands == ' ') continue;
      if (style.thousands && !mayGroup(style.thousands, delimiter)) continue;
      if (delimiter != ',' && text.find(delimiter) == std::string_view::npos) continue;
      Dialect dialect{delimiter, style, false, 0};
      judge(dialect, lines);
      constexpr double least = 0.005;  // share of the rows
      if (dialect.score > best.score + least) best = dialect;
    }
  return best;
}

/// Columns separated by blanks. If titles contain blanks or cells are empty, each text belongs to the column
/// above or below it.
class FixedColumns {
 public:
  FixedColumns(std::string_view text, const Dialect& dialect) : style_(dialect.style) {
    if (dialect.delimiter != ' ') return;
    std::map<std::size_t, std::size_t> widths;
    const std::vector<std::string_view> lines = sampledLines(text);
    for (const std::string_view line : lines)
      if (const auto cells = split(line, 1); isOfNumbers(cells)) ++widths[cells.size()];
    std::size_t usual = 0, most = 0;
    for (const auto& [width, count] : widths)
      if (count > most) most = count, usual = width;
    if (usual == 0) return;
    middles_.assign(usual, 0);
    double rows = 0;
    for (const std::string_view line : lines) {
      const auto cells = split(line, 1);
      if (cells.size() != usual || !isOfNumbers(cells)) continue;
      for (std::size_t i = 0; i < usual; ++i) middles_[i] += middleOf(cells[i], line);
      ++rows;
    }
    for (double& middle : middles_) middle /= rows;
  }

  std::vector<std::string_view> cellsOf(std::string_view line) const {
    std::vector<std::string_view> cells = split(line, 1);
    if (cells.size() == middles_.size() && isOfNumbers(cells)) return cells;
    std::vector<std::string_view> parts = split(line, 2);
    if (parts.size() < 2 || parts.size() > middles_.size()) return cells;
    if (parts.size() == middles_.size()) return parts;
    std::vector<std::string_view> placed(middles_.size());
    for (const std::string_view cell : parts) {
      std::size_t nearest = 0;
      for (std::size_t i = 1; i < middles_.size(); ++i)
        if (std::abs(middles_[i] - middleOf(cell, line)) < std::abs(middles_[nearest] - middleOf(cell, line)))
          nearest = i;
      placed[nearest] = cell;
    }
    return placed;
  }

 private:
  static double middleOf(std::string_view cell, std::string_view line) {
    return static_cast<double>(cell.data() - line.data()) + 0.5 * static_cast<double>(cell.size());
  }

  /// Returns true for a row with at least two numbers and at most one word, such as "down" or "up".
  bool isOfNumbers(const std::vector<std::string_view>& cells) const {
    const auto numbers = std::ranges::count_if(
        cells, [&](std::string_view cell) { return numberIn(cell, style_).has_value(); });
    return numbers >= 2 && static_cast<std::size_t>(numbers) + 1 >= cells.size();
  }

  /// Parts of a line that are separated by at least `blanks` blanks, or by a tab.
  static std::vector<std::string_view> split(std::string_view line, std::size_t blanks) {
    std::vector<std::string_view> parts;
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    for (std::size_t at = line.find_first_not_of(" \t"); at < line.size();) {
      std::size_t end = at;
      // A quoted title may contain blanks.
      if (const std::size_t close = line[at] == '"' ? line.find('"', at + 1) : std::string_view::npos;
          close != std::string_view::npos && (close + 1 == line.size() || isBlank(line[close + 1])))
        end = close + 1;
      while (end < line.size()) {
        const std::size_t next = line.find_first_not_of(" \t", end);
        if (next != end &&
            (next - end >= blanks || line.substr(end, next - end).find('\t') != std::string_view::npos))
          break;
        end = next == end ? end + 1 : next;
      }
      parts.push_back(line.substr(at, end - at));
      at = std::min(line.find_first_not_of(" \t", end), line.size());
    }
    return parts;
  }

  NumberStyle style_;
  std::vector<double> middles_;  // middle of each column, in bytes from the start of the line
};

/// Adds a cell without its quotation marks; doubled ones inside become single.
void addTextCell(Table& table, std::string_view raw) {
  const std::string_view cell = withoutQuotes(raw);
  if (cell.find('"') == std::string_view::npos) return table.addCell(cell);
  std::string plain;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    plain += cell[i];
    if (cell[i] == '"' && i + 1 < cell.size() && cell[i + 1] == '"') ++i;
  }
  table.addOwnCell(std::move(plain));
}

}  // namespace

Result<Table> tableOfText(std::string content, const std::string& subject, const Progress& progress) {
  Table table;
  const std::string_view text = table.keep(std::move(content));
  const Dialect dialect = dialectOf(text);
  table.style = dialect.style;
  const FixedColumns fixed(text, dialect);
  long line = 1;
  for (std::size_t at = 0; at < text.size();) {
    table.beginRow(line);
    const std::size_t from = at;
    std::vector<std::string_view> halves;
    if (dialect.delimiter == ' ') {
      const std::size_t end = lineEnd(text, at);
      for (const std::string_view cell : fixed.cellsOf(text.substr(at, end - at))) addTextCell(table, cell);
      at = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    } else {
      at = splitLine(text, at, dialect.delimiter, [&](std::string_view cell) {
        if (dialect.commaComma)
          halves.push_back(trimmed(cell));
        else
          addTextCell(table, cell);
      });
    }
    at = std::min(at, text.size());
    if (at - from > longestTextLine_bytes)
      return Failure{FailureCode::unreadableInput, subject, "line " + std::to_string(line),
                     Message("the line is too long"), Message("Give a table with one sample per line")};
    if (dialect.commaComma) {
      const bool numbers = halves.size() >= 4 && halves.size() % 2 == 0 &&
                           std::ranges::all_of(halves, [](std::string_view half) {
                             return !half.empty() && (isDigit(half[0]) || half[0] == '-');
                           });
      if (numbers)
        for (std::size_t i = 0; i + 1 < halves.size(); i += 2)
          table.addOwnCell(std::string(halves[i]) + "," + std::string(halves[i + 1]));
      else
        for (const std::string_view half : halves) addTextCell(table, half);
    }
    const std::string_view given = text.substr(from, at - from);
    // A quoted field may hold line breaks.
    line += given.find('"') == std::string_view::npos
                ? 1
                : std::max<long>({1, std::ranges::count(given, '\n'), std::ranges::count(given, '\r')});
    if ((table.rows() & 0x3FFF) != 0) continue;
    if (progress.report) progress.report(0.5 * double(at) / double(text.size()), ImportStep::read);
    if (progress.isCancelled()) return Failure::cancelled(subject);
  }
  return table;
}

FileContent contentOf(std::string_view bytes) {
  if (bytes.starts_with("PK\x03\x04")) return FileContent::spreadsheet;
  if (bytes.starts_with("\xD0\xCF\x11\xE0")) return FileContent::oldSpreadsheet;
  if (bytes.size() > 262 && bytes.substr(257, 5) == "ustar") return FileContent::tar;
  return FileContent::text;
}

namespace {

/// Converts bytes of a charset known to glibc to UTF-8; nullopt if they are invalid in it. An incomplete last
/// character is dropped.
std::optional<std::string> decoded(std::string_view bytes, const char* charset) {
  const iconv_t converter = iconv_open("UTF-8", charset);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the value that iconv_open() states for a failure
  if (converter == reinterpret_cast<iconv_t>(-1)) return {};
  std::string in(bytes), out(3 * bytes.size() + 16, '\0');
  char *from = in.data(), *to = out.data();
  std::size_t left = in.size(), room = out.size();
  const bool isWhole =
      iconv(converter, &from, &left, &to, &room) != static_cast<std::size_t>(-1) || errno == EINVAL;
  iconv_close(converter);
  if (!isWhole) return {};
  out.resize(out.size() - room);
  return out;
}

/// Converts text of a national charset. The charset is the one in which most text beyond ASCII consists of
/// known words of tables; nullopt if no charset gives such words.
std::optional<std::string> decodedByWords(const std::string& bytes) {
  constexpr std::size_t head_bytes = 4096;
  const char* best = nullptr;
  std::size_t most = 0;
  for (const char* charset : {"CP1252", "CP932", "CP949", "GB18030", "BIG5", "CP1251", "CP1250"}) {
    const auto text = decoded(std::string_view(bytes).substr(0, head_bytes), charset);
    if (!text) continue;
    // A single ideograph may be a coincidence in another charset.
    constexpr std::size_t byChance_bytes = 3;
    std::size_t known_bytes = 0;
    constexpr std::string_view separators = " \t\r\n,;:()[]/\"";
    for (std::size_t at = 0; at < text->size();) {
      const std::size_t end = std::min(text->find_first_of(separators, at), text->size());
      const std::string_view part = std::string_view(*text).substr(at, end - at);
      for (const KnownWords::Word& word : knownWordsIn(part).words) {
        // The word as written is counted, because folding may have shortened it.
        const bool isWhole = folded(part) == word.text;
        if (isAscii(isWhole ? part : word.text)) continue;
        const std::size_t size = isWhole ? part.size() : word.text.size();
        known_bytes += size > byChance_bytes ? size : 1;
      }
      at = end + 1;
    }
    if (known_bytes > most) best = charset, most = known_bytes;
  }
  return best ? decoded(bytes, best) : std::nullopt;
}

}  // namespace

std::optional<std::string> utf8From(std::string bytes) {
  const std::string_view head = std::string_view(bytes).substr(0, 4096);
  std::size_t zerosEven = 0, zerosOdd = 0;
  for (std::size_t i = 0; i < head.size(); ++i)
    if (head[i] == 0) ++(i % 2 ? zerosOdd : zerosEven);
  const bool littleMark = head.starts_with("\xFF\xFE"), bigMark = head.starts_with("\xFE\xFF");
  const bool marked = littleMark || bigMark;
  const bool little = littleMark || (!marked && zerosOdd > head.size() / 5 && zerosEven < head.size() / 50);
  const bool big = bigMark || (!marked && zerosEven > head.size() / 5 && zerosOdd < head.size() / 50);
  if (little || big) {
    auto text = decoded(std::string_view(bytes).substr(marked ? 2 : 0), little ? "UTF-16LE" : "UTF-16BE");
    return text && text->find('\0') == std::string::npos ? std::move(text) : std::nullopt;
  }
  const auto isControl = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && !isBlank(c) && c != 0x1A;
  };
  if (std::ranges::any_of(head, isControl)) return {};
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  // Excel writes the delimiter in a first line "sep=".
  if (bytes.starts_with("sep=")) bytes.erase(0, std::min(bytes.find('\n'), bytes.size() - 1) + 1);
  if (isUtf8(bytes)) return bytes;
  if (auto text = decodedByWords(bytes)) return text;
  return decoded(bytes, "ISO-8859-1");
}

}  // namespace detent::importer
