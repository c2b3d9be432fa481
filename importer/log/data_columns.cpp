// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/data_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

#include "importer/lexicon/lexicon.h"
#include "model/text.h"

namespace detent::importer {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostColumns = 256;

/// A row, described by the kinds of its cells.
struct RowFacts {
  std::uint32_t numbers = 0, texts = 0, words = 0;  ///< words: texts with a letter that are no "nan" or "inf"
  std::size_t width = 0;
  bool isBlank() const { return numbers + texts == 0; }
  bool isVoid() const {
    return !isBlank() && words == 0;
  }  ///< "nan,nan", "--,--": a row of data without data
};

std::string joinedCells(const Table& table, std::size_t row, const char* separator = " ") {
  std::string text;
  for (std::size_t c = 0; c < table.cells(row); ++c) {
    const std::string_view cell = table.cell(row, c);
    if (!cell.empty()) text += (text.empty() ? "" : separator) + std::string(cell);
  }
  return text;
}

std::string_view withoutComment(std::string_view cell) {
  while (!cell.empty() &&
         (cell.front() == '#' || cell.front() == '%' || cell.front() == '/' || cell.front() == ';'))
    cell = trimmed(cell.substr(1));
  return cell;
}

/// The text outside of brackets; the whole text if all of it is in brackets.
std::string outsideBrackets(const std::string& text) {
  std::string outside;
  int depth = 0;
  for (const char c : text) {
    if (c == '(' || c == '[')
      ++depth;
    else if ((c == ')' || c == ']') && depth > 0)
      --depth;
    else if (depth == 0)
      outside += c;
  }
  return trimmed(outside).empty() ? text : outside;
}

ColumnQuantity quantityOf(const KnownWords& words) {
  ColumnQuantity head = ColumnQuantity::none;
  constexpr std::pair<ColumnWord, ColumnQuantity> kinds[] = {
      {ColumnWord::displacement, ColumnQuantity::displacement},
      {ColumnWord::force, ColumnQuantity::force},
      {ColumnWord::other, ColumnQuantity::other},
      {ColumnWord::time, ColumnQuantity::time},
      {ColumnWord::contact, ColumnQuantity::contact},
      {ColumnWord::cycle, ColumnQuantity::cycle},
      {ColumnWord::index, ColumnQuantity::index},
      {ColumnWord::displacementWeak, ColumnQuantity::displacementWeak},
      {ColumnWord::forceWeak, ColumnQuantity::forceWeak}};
  const auto isWeak = [](ColumnQuantity q) {
    return q == ColumnQuantity::none || q == ColumnQuantity::displacementWeak ||
           q == ColumnQuantity::forceWeak || q == ColumnQuantity::index || q == ColumnQuantity::cycle ||
           q == ColumnQuantity::contact;
  };
  for (const KnownWords::Word& word : words.words) {
    if (word.has(ColumnWord::raw) && head == ColumnQuantity::none) head = ColumnQuantity::other;
    for (const auto& [meaning, quantity] : kinds) {
      if (!word.has(meaning)) continue;
      // A compound's last noun names the quantity (in Romance languages the first). Indices, cycles and
      // single letters give way to real quantities.
      if (isWeak(head) || (!words.headFirst && !isWeak(quantity))) head = quantity;
      break;
    }
  }
  return head;
}

/// Returns true for a number with other text: "0.1 mm/s" as a title states the speed of the record, not the
/// unit.
bool isCondition(std::string_view title) {
  for (const std::string_view sign : {"-", "+", "±", "−"})
    if (title.starts_with(sign)) title.remove_prefix(sign.size());
  return !title.empty() && title.front() >= '0' && title.front() <= '9';
}

/// Returns true for a condition that is followed by the unit of the numbers in brackets: "85 °C (N)".
bool isConditionWithUnit(std::string_view title) {
  const ColumnUnit unit = splitTitle(title).unit;
  return isCondition(title) && (title.ends_with(')') || title.ends_with(']')) && unit.isOfButton();
}

/// Returns true if a column's title says which of several specimens was measured, and not which quantity: a
/// condition, or a word for a specimen with its letter or number.
bool namesRecordIn(const DataColumn& column) {
  const KnownWords& words = column.words;
  for (const ColumnWord word : {ColumnWord::force, ColumnWord::displacement, ColumnWord::copy,
                                ColumnWord::spread, ColumnWord::mean, ColumnWord::contact})
    if (words.has(word)) return false;
  if (column.isText || (column.isInteger && column.low >= 0 && column.high <= 1)) return false;
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const std::string& title = column.title;
  const auto isLetter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  };
  if (isCondition(title)) return std::ranges::any_of(title, isLetter);
  const bool isStated = words.words.size() + words.unknown > 1 || std::ranges::any_of(title, isDigit);
  if (words.has(ColumnWord::record) && isStated) return true;
  return words.has(ColumnWord::cycle) && column.unit.kind == ColumnUnit::Kind::force &&
         std::ranges::any_of(title, isDigit);
}

/// Log-likelihood that a column is a force, or a displacement, by its title, unit and values.
double likelihood(const DataColumn& column, bool force) {
  if (column.isText) return -20;
  using Kind = ColumnUnit::Kind;
  const Kind own = force ? Kind::force : Kind::displacement, rival = force ? Kind::displacement : Kind::force;
  double sum = 0;
  if (column.unit.kind == own)
    sum += 3;
  else if (column.unit.kind == rival || column.unit.kind == Kind::time)
    sum -= 8;
  else if (column.unit.kind == Kind::other)
    sum -= 10;
  else if (column.unit.kind == Kind::unknown)
    sum -= 1;
  const bool ownWord = column.quantity == (force ? ColumnQuantity::force : ColumnQuantity::displacement);
  const bool ownWeak =
      column.quantity == (force ? ColumnQuantity::forceWeak : ColumnQuantity::displacementWeak);
  if (ownWord)
    sum += 3;
  else if (ownWeak)
    sum += 1;
  else if (column.quantity == ColumnQuantity::forceWeak ||
           column.quantity == ColumnQuantity::displacementWeak)
    sum -= column.unit.kind == own ? 0 : 2;  // "S-101 (N)"
  else if (column.quantity != ColumnQuantity::none && !column.ratioGiven)
    sum -= 6;
  else if (column.unit.kind == Kind::none && !column.title.empty() && !column.has(ColumnWord::press) &&
           !column.has(ColumnWord::release))
    sum -= 1;
  // Titles such as "Peak force" and "Filtered force" name a second form of a force. "Stress" with the unit N
  // may still be a force.
  if (column.words.has(ColumnWord::copy) || column.words.has(ColumnWord::spread)) sum -= 3;
  if (column.words.has(ColumnWord::other) && column.quantity != ColumnQuantity::other) sum -= 1.5;
  if (column.isConstant()) sum -= 15;
  if (force && column.countsRows()) sum -= 6;
  return sum;
}

void weigh(DataColumn& column) {
  column.displacement = likelihood(column, false), column.force = likelihood(column, true);
}

class ColumnFinder {
 public:
  explicit ColumnFinder(const Table& table) : table_(table) {}

  std::optional<DataTable> find() {
    readNumbers();
    if (!findMainRun()) return {};
    takeRows();
    if (data_.rowOf.empty()) return {};
    takeColumns();
    if (data_.columns.size() < 2) return {};
    readHeadings();
    readUnitsBeside();
    readUnitsAbove();
    for (DataColumn& column : data_.columns) settle(column);
    return std::move(data_);
  }

 private:
  void readNumbers() {
    std::size_t width = 0;
    facts_.resize(table_.rows());
    for (std::size_t row = 0; row < table_.rows(); ++row) width = std::max(width, table_.cells(row));
    width_ = std::min(width, kMostColumns);
    numbers_.assign(width_, std::vector<double>(table_.rows(), kNoNumber));
    decimals_.assign(width_, std::numeric_limits<int>::min());
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      RowFacts& facts = facts_[row];
      facts.width = table_.cells(row);
      for (std::size_t c = 0; c < std::min(width_, facts.width); ++c) {
        const std::string_view cell = table_.cell(row, c);
        if (cell.empty()) continue;
        const auto number = numberIn(cell, table_.style);
        // "1 mm" is a number with a unit; "1 Switch A" is a text.
        const bool isNumber =
            number && (number->rest.empty() || unitOf(number->rest).kind != ColumnUnit::Kind::unknown);
        if (!isNumber || !std::isfinite(number->value)) {
          ++facts.texts;
          facts.words += !number && std::ranges::any_of(cell, [](char ch) {
            return (ch >= 'a' && ch <= 'z') || (ch >= 'A' && ch <= 'Z') ||
                   static_cast<unsigned char>(ch) >= 0x80;
          });
          continue;
        }
        ++facts.numbers;
        numbers_[c][row] = number->value;
        decimals_[c] = std::max(decimals_[c], number->decimals);
      }
    }
  }

  bool isNumber(std::size_t row, std::size_t column) const { return !std::isnan(numbers_[column][row]); }
  bool isCandidate(std::size_t row) const { return facts_[row].numbers >= 2; }

  /// Finds the longest run of rows of numbers; its numeric cells make the columns.
  bool findMainRun() {
    std::size_t best = 0;
    for (std::size_t row = 0; row < table_.rows();) {
      if (!isCandidate(row)) {
        ++row;
        continue;
      }
      std::size_t end = row;
      while (end < table_.rows() && isCandidate(end)) ++end;
      if (end - row > best) best = end - row, mainFrom_ = row, mainTo_ = end;
      row = end;
    }
    if (best == 0) return false;
    for (std::size_t c = 0; c < width_; ++c) {
      std::size_t count = 0, texts = 0;
      for (std::size_t row = mainFrom_; row < mainTo_; ++row) {
        count += isNumber(row, c);
        texts += !isNumber(row, c) && !table_.cell(row, c).empty();
      }
      constexpr double coreShare = 0.9, leastShare = 0.02;
      const double share = static_cast<double>(count) / static_cast<double>(best);
      if (share >= coreShare) core_.push_back(c);
      if (count >= std::min<std::size_t>(2, best) && share >= leastShare && texts <= count)
        numeric_.push_back(c);
      else if (texts * 2 >= best || texts >= 2)
        text_.push_back(c);
    }
    if (core_.size() < 2) core_ = numeric_;
    return numeric_.size() >= 2;
  }

  bool isData(std::size_t row) const {
    if (!isCandidate(row)) return false;
    // A row with a text in a column of numbers is a heading, even if its other cells are numbers: "Travel",
    // 0.1, 0.5.
    for (const std::size_t c : core_)
      if (!isNumber(row, c) && !table_.cell(row, c).empty()) return false;
    // A row of conditions above pairs of columns is a heading: "-40 °C;;85 °C;".
    if (facts_[row].numbers < core_.size() && holdsConditions(row) && !holdsConditions(mainTo_ - 1))
      return false;
    return std::ranges::count_if(numeric_, [&](std::size_t c) { return isNumber(row, c); }) >= 2;
  }

  /// The texts of a row without numbers and blanks, for comparing headings.
  std::string headingText(std::size_t row) const {
    std::string text;
    for (std::size_t c = 0; c < facts_[row].width; ++c)
      if (!(c < width_ && isNumber(row, c)) && !table_.cell(row, c).empty())
        text += lowered(table_.cell(row, c)) + "|";
    return text;
  }

  /// Returns true for a cell that may be a title: any text, or a number with a unit, such as "0.1 mm/s".
  bool isTitle(std::size_t row, std::size_t column) const {
    const std::string_view cell = table_.cell(row, column);
    if (cell.empty()) return false;
    if (!isNumber(row, column)) return true;
    const auto number = numberIn(cell, table_.style);
    return number && !number->rest.empty();
  }

  /// Range [from, to) of heading rows directly above a row of data.
  std::pair<std::size_t, std::size_t> headingAbove(std::size_t dataRow) const {
    constexpr std::size_t mostLines = 6;
    std::size_t to = dataRow;
    // One blank row may separate headings and data.
    if (to > 0 && facts_[to - 1].isBlank()) --to;
    const std::size_t lowest = to;
    std::size_t from = to;
    while (from > 0 && to - from < mostLines) {
      const std::size_t row = from - 1;
      // One blank row may also separate headings from remarks below them.
      if (from == to && to < lowest && facts_[row].isBlank() && lowest - to < mostLines) {
        --to, --from;
        continue;
      }
      if (facts_[row].isBlank() || isData(row)) break;
      if (from == to && (facts_[row].isVoid() || isBesideColumns(row))) {
        --to, --from;
        continue;
      }
      const std::string_view first = table_.cell(row, 0);
      if (first.find('=') != std::string_view::npos || first.ends_with(':')) break;  // a preamble's
      std::size_t over = 0;
      for (const std::size_t c : numeric_) over += isTitle(row, c);
      if (from < to && isTableTitle(row, from)) break;
      const bool covers = over * 2 >= numeric_.size();
      const bool isGroup =
          from < to && (over >= 2 || (over == 1 && facts_[row].width >=
                                                       std::min(facts_[from].width, numeric_.back() + 1)));
      if (!covers && !isGroup) break;
      // Lines such as "Name: value" belong to the preamble.
      if (facts_[row].texts <= 2 && numeric_.size() > 2 && facts_[row].width <= 2) break;
      if (from < to && numeric_.size() == 2 && !isGroup) break;
      if (from < to && isPreambleLine(row)) break;
      --from;
    }
    if (from == to) from = to = lowest;
    // Texts directly below data are a heading only if they name a measured quantity. "over range,error" is a
    // failed row.
    std::size_t before = from;
    while (before > 0 && facts_[before - 1].isVoid() && !isData(before - 1)) --before;
    if (from < to && before > 0 && isData(before - 1) && !namesColumns(from, to)) from = to;
    return {from, to};
  }

  /// Returns true for a row with remarks in other columns, and nothing in the data's columns.
  bool isBesideColumns(std::size_t row) const {
    return !facts_[row].isBlank() &&
           std::ranges::all_of(core_, [&](std::size_t c) { return table_.cell(row, c).empty(); });
  }

  /// Returns true for a row that lacks a number, but has the texts of a row of data above it ("press" in the
  /// column of the stroke): a reading that failed, not the heading of what follows.
  bool isFailedReading(std::size_t row, std::size_t above) const {
    const auto textAt = [&](std::size_t c) { return table_.cell(row, c); };
    return std::ranges::any_of(text_, [&](std::size_t c) { return !textAt(c).empty(); }) &&
           std::ranges::all_of(text_, [&](std::size_t c) { return textAt(c) == table_.cell(above, c); });
  }

  /// Returns true for a single text at the left, above the titles of the columns. "Release" or "Release;;;"
  /// names the table, not its first column.
  bool isTableTitle(std::size_t row, std::size_t below) const {
    if (facts_[row].texts != 1 || facts_[row].numbers > 0) return false;
    std::size_t at = 0;
    while (table_.cell(row, at).empty()) ++at;
    std::size_t titles = 0;
    for (const std::size_t c : numeric_) titles += isTitle(below, c);
    if (at > numeric_.front() || titles < 2) return false;
    // A quantity may be named once above its units. A word that may also name a stroke, such as "load", is
    // not taken as a quantity here.
    const SplitTitle split = splitTitle(table_.cell(row, at));
    bool displacement = false, force = false;
    for (const KnownWords::Word& word : knownWordsIn(split.name).words)
      if (!word.has(ColumnWord::press) && !word.has(ColumnWord::release)) {
        displacement = displacement || word.has(ColumnWord::displacement);
        force = force || word.has(ColumnWord::force);
      }
    return !split.unit.isKnown() && force == displacement;
  }

  bool namesColumns(std::size_t from, std::size_t to) const {
    for (std::size_t row = from; row < to; ++row)
      for (const std::size_t c : numeric_) {
        const SplitTitle split = splitTitle(table_.cell(row, c));
        if (split.unit.isOfButton()) return true;
        const ColumnQuantity quantity = quantityOf(knownWordsIn(split.name));
        if (quantity == ColumnQuantity::displacement || quantity == ColumnQuantity::force) return true;
      }
    return false;
  }

  /// Returns true if the numbers of a row all have one unit: "-40 °C;85 °C".
  bool holdsConditions(std::size_t row) const {
    std::set<std::string_view> units;
    for (std::size_t c = 0; c < facts_[row].width; ++c)
      if (c < width_ && isNumber(row, c)) units.insert(table_.number(row, c)->rest);
    return facts_[row].numbers >= 2 && units.size() == 1 && !units.begin()->empty();
  }

  /// Returns true for a line of a preamble that has as many cells as the data: "Serial,123456",
  /// "Date;2024-05-01".
  bool isPreambleLine(std::size_t row) const {
    if (facts_[row].numbers > 0) return !holdsConditions(row);
    // The titles of the columns follow below. A line above them without known words can only be a group
    // heading if it has empty cells.
    if (facts_[row].texts >= numeric_.size() && numeric_.size() <= 3) {
      std::size_t known = 0;
      for (std::size_t c = 0; c < facts_[row].width; ++c) {
        const SplitTitle split = splitTitle(table_.cell(row, c));
        known += split.unit.isKnown();
        known += !knownWordsIn(split.name).words.empty();
      }
      return known < numeric_.size();
    }
    return false;
  }

  void leaveOut(std::size_t row) {
    if (data_.leftOut++ > 0) return;
    constexpr std::size_t longest_bytes = 40;
    data_.firstLeftOutLine = table_.line(row);
    data_.firstLeftOutText = joinedCells(table_, row, ",").substr(0, longest_bytes);
  }

  /// The title and unit above each column of the table.
  std::vector<SplitTitle> titlesAbove(std::size_t dataRow) const {
    const auto [from, to] = headingAbove(dataRow);
    std::vector<SplitTitle> titles(width_);
    for (std::size_t c = 0; c < width_; ++c)
      for (std::size_t row = to; row-- > from;) {
        const SplitTitle split = splitTitle(table_.cell(row, c));
        if (titles[c].unit.kind == ColumnUnit::Kind::none) titles[c].unit = split.unit;
        titles[c].name = lowered(split.name) + " " + titles[c].name;
      }
    for (SplitTitle& title : titles) title.name = std::string(trimmed(title.name));
    return titles;
  }

  /// Converts a further block to the columns and units of the longest block, if its columns are in another
  /// order or in other units of the same quantities. Returns false, and changes nothing, if its titles
  /// differ.
  bool bringIntoColumns(std::size_t firstRow) {
    std::size_t end = firstRow;
    while (end < table_.rows() && isData(end)) ++end;
    constexpr std::size_t fewestRows = 4;
    if (end - firstRow < fewestRows) return false;
    const std::vector<SplitTitle> wanted = titlesAbove(mainFrom_), own = titlesAbove(firstRow);
    std::map<std::size_t, std::size_t> from;
    for (const std::size_t c : numeric_)
      for (std::size_t other = 0; other < width_; ++other) {
        if (own[other].name != wanted[c].name || own[other].unit.kind != wanted[c].unit.kind) continue;
        if (own[other].name.empty() && own[other].unit.kind == ColumnUnit::Kind::none) continue;
        if (!from.emplace(c, other).second) return false;  // two columns of one title
      }
    std::set<std::size_t> taken;
    bool displacement = false, force = false;
    for (const auto& [c, other] : from) {
      if (!taken.insert(other).second) return false;
      displacement = displacement || wanted[c].unit.kind == ColumnUnit::Kind::displacement;
      force = force || wanted[c].unit.kind == ColumnUnit::Kind::force;
    }
    const bool whole = std::ranges::all_of(core_, [&](std::size_t c) { return from.contains(c); });
    if (!whole || !displacement || !force) return false;
    for (std::size_t row = firstRow; row < end; ++row) {
      std::map<std::size_t, double> values;
      for (const auto& [c, other] : from)
        values[c] = numbers_[other][row] * (own[other].unit.size / wanted[c].unit.size);
      for (const std::size_t c : numeric_) numbers_[c][row] = values.contains(c) ? values[c] : kNoNumber;
    }
    return true;
  }

  void takeRows() {
    heading_ = headingAbove(mainFrom_);
    const auto headingOf = [&](std::size_t dataRow) {
      const auto [from, to] = headingAbove(dataRow);
      std::string text;
      for (std::size_t row = from; row < to; ++row) text += headingText(row) + "\n";
      return text;
    };
    const std::string mainHeading = headingOf(mainFrom_);
    bool begun = false, foreign = false, firstBrought = false;
    std::string between;
    bool interrupted = false;
    std::size_t firstRow = mainFrom_;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      if (!isData(row)) {
        const bool reading = begun && isFailedReading(row, data_.rowOf.back());
        if (!facts_[row].isBlank() && !reading)
          between += (between.empty() ? "" : "\n") + joinedCells(table_, row);
        interrupted = interrupted || (!reading && (facts_[row].isBlank() || facts_[row].numbers < 2));
        if (facts_[row].isVoid() || (begun && !facts_[row].isBlank())) leaveOut(row);
        continue;
      }
      if (interrupted || row == 0) {
        // A run of rows under another heading belongs to another table.
        const std::string own = headingOf(row);
        if (row == mainFrom_)
          foreign = false;
        else if (!own.empty()) {
          const bool other = own != mainHeading && !mainHeading.empty();
          foreign = other && !bringIntoColumns(row);
          firstBrought = firstBrought || (!begun && other && !foreign);
        } else if (!begun && !foreign)
          foreign = row < mainFrom_ && !mainHeading.empty();
      }
      if (foreign) {
        if (begun) leaveOut(row);
        continue;
      }
      if (begun && interrupted) data_.breaks.push_back({data_.rowOf.size(), between});
      if (!begun) firstRow = row;
      begun = true, interrupted = false;
      between.clear();
      data_.rowOf.push_back(row);
    }
    // Lines above the headings of the first run of data.
    const auto [from, to] = headingAbove(firstRow);
    if (to > from && !firstBrought) heading_ = {from, to};
    const std::size_t captionsEnd = firstBrought ? from : std::min(heading_.first, firstRow);
    for (std::size_t row = 0; row < captionsEnd; ++row)
      if (!facts_[row].isBlank()) data_.captions.push_back(joinedCells(table_, row, "\t"));
  }

  void takeColumns() {
    for (const std::size_t c : numeric_) {
      DataColumn column;
      column.index = c;
      column.values.reserve(data_.rows());
      column.low = std::numeric_limits<double>::infinity(), column.high = -column.low;
      column.isInteger = true;
      for (const std::size_t row : data_.rowOf) {
        const double value = numbers_[c][row];
        column.values.push_back(value);
        if (std::isnan(value)) continue;
        ++column.count;
        column.low = std::min(column.low, value), column.high = std::max(column.high, value);
        column.isInteger = column.isInteger && value == std::floor(value);
      }
      column.decimals = decimals_[c];
      if (column.count >= 1) data_.columns.push_back(std::move(column));
    }
    for (const std::size_t c : text_) {
      DataColumn column;
      column.index = c;
      column.isText = true;
      data_.columns.push_back(std::move(column));
    }
    std::ranges::sort(data_.columns, {}, &DataColumn::index);
  }

  /// Returns true for a first column that numbers the rows from 1, without a title above it. R writes tables
  /// so: every title stands one cell to the left of its column.
  bool namesRows() const {
    const auto [from, to] = heading_;
    const DataColumn& first = data_.columns.front();
    if (from == to || first.index != 0 || first.isText || table_.cell(to - 1, 0).empty()) return false;
    for (std::size_t i = 0; i < first.values.size(); ++i)
      if (first.values[i] != static_cast<double>(i + 1)) return false;
    for (std::size_t row = from; row < to; ++row)
      for (std::size_t c = data_.columns.back().index; c < table_.cells(row); ++c)
        if (!table_.cell(row, c).empty()) return false;
    if (table_.cell(to - 1, data_.columns.back().index - 1).empty()) return false;
    // Not if the first title may be that of the row numbers, or if the last column is constant.
    const SplitTitle title = splitTitle(table_.cell(to - 1, 0));
    const ColumnQuantity quantity = quantityOf(knownWordsIn(title.name));
    const DataColumn& last = data_.columns.back();
    return quantity != ColumnQuantity::index && quantity != ColumnQuantity::cycle &&
           (quantity != ColumnQuantity::none || title.unit.isKnown()) && (last.isText || !last.isConstant());
  }

  void readHeadings() {
    const auto [from, to] = heading_;
    const std::size_t shift = namesRows() ? 1 : 0;
    for (DataColumn& column : data_.columns) {
      if (column.index < shift) {
        column.title = "row";
        continue;
      }
      for (std::size_t row = to; row-- > from;) {
        // NumPy writes "# displacement force": only the heading begins with the sign, so its cells are one to
        // the right.
        const bool isMarked =
            table_.cell(row, 0) == "#" && table_.cells(row) > data_.columns.back().index + 1;
        const std::size_t at = isMarked ? column.index + 1 : column.index - shift;
        const std::string_view cell = withoutComment(table_.cell(row, at));
        if (cell.empty()) continue;
        if (isCondition(cell) && !isConditionWithUnit(cell)) {
          column.title = std::string(cell) + (column.title.empty() ? "" : " " + column.title);
          continue;
        }
        if (readScale(cell, column)) continue;
        const SplitTitle split = splitTitle(cell);
        if (!column.unit.isKnown() && split.unit.kind != ColumnUnit::Kind::none) column.unit = split.unit;
        if (!split.name.empty()) column.title = split.name + (column.title.empty() ? "" : " " + column.title);
      }
    }
    if (shift > 0) return;
    // The topmost heading line with empty cells is a group heading: each text applies to the empty cells on
    // its right too.
    for (std::size_t row = from; row + 1 < to; ++row) {
      std::string carried;
      bool hasGap = false;
      for (std::size_t c = 0; c <= data_.columns.back().index; ++c)
        hasGap = hasGap || table_.cell(row, c).empty();
      if (!hasGap) continue;
      for (std::size_t c = 0; c <= data_.columns.back().index; ++c) {
        const std::string_view cell = table_.cell(row, c);
        if (!cell.empty()) carried = std::string(cell);
        for (DataColumn& column : data_.columns) {
          if (column.index != c || carried.empty()) continue;
          column.group += (column.group.empty() ? "" : " ") + carried;
          // The cell's own text is already part of the title.
          if (!cell.empty()) {
            const std::string name = splitTitle(cell).name;
            if (column.title.starts_with(name) && column.title.size() > name.size())
              column.title = std::string(trimmed(std::string_view(column.title).substr(name.size())));
          }
        }
      }
    }
  }

  /// Reads units that follow the numbers, or that stand in a separate column on the right.
  void readUnitsBeside() {
    constexpr std::size_t looked = 50;
    for (std::size_t i = 0; i < data_.columns.size(); ++i) {
      DataColumn& column = data_.columns[i];
      if (column.isText) continue;
      std::string behind;
      bool same = true;
      for (std::size_t r = 0; r < std::min(looked, data_.rows()) && same; ++r) {
        const auto number = table_.number(data_.rowOf[r], column.index);
        if (!number) continue;
        if (behind.empty()) behind = std::string(number->rest);
        same = number->rest == behind && !behind.empty();
      }
      ColumnUnit unit = same ? unitOf(behind) : ColumnUnit{};
      if (unit.kind == ColumnUnit::Kind::none && i + 1 < data_.columns.size() &&
          data_.columns[i + 1].isText && data_.columns[i + 1].index == column.index + 1) {
        std::set<std::string_view> texts;
        for (std::size_t r = 0; r < std::min(looked, data_.rows()); ++r)
          texts.insert(table_.cell(data_.rowOf[r], column.index + 1));
        if (texts.size() == 1) unit = unitOf(*texts.begin());
      }
      if (unit.isKnown() && !column.unit.isKnown()) column.unit = unit;
    }
  }

  /// Reads units from lines above the table: "UNIT = gf,mm", "Force unit: cN", "steps_per_mm = 800".
  void readUnitsAbove() {
    for (const std::string& caption : data_.captions) {
      std::vector<std::string_view> cells;
      for (std::size_t at = 0; at <= caption.size();) {
        const std::size_t end = std::min(caption.find('\t', at), caption.size());
        cells.push_back(trimmed(std::string_view(caption).substr(at, end - at)));
        at = end + 1;
      }
      const std::string_view first = withoutComment(cells.front());
      const std::size_t sign = first.find_first_of("=:");
      const std::string_view name = trimmed(first.substr(0, sign));
      const std::string_view value = sign != std::string_view::npos ? trimmed(first.substr(sign + 1))
                                     : cells.size() > 1             ? cells[1]
                                                                    : std::string_view();
      readRatio(name, value);
      const KnownWords words = knownWordsIn(name);
      if (!words.has(ColumnWord::unit)) continue;
      const ColumnQuantity quantity = quantityOf(words);
      if (quantity == ColumnQuantity::none || quantity == ColumnQuantity::forceWeak ||
          quantity == ColumnQuantity::displacementWeak) {
        std::vector<std::string_view> units{value};
        for (std::size_t i = sign != std::string_view::npos && !value.empty() ? 1 : 2; i < cells.size(); ++i)
          units.push_back(cells[i]);
        std::vector<DataColumn*> numeric;
        for (DataColumn& column : data_.columns)
          if (!column.isText) numeric.push_back(&column);
        while (!units.empty() && units.back().empty()) units.pop_back();
        if (units.size() == 1 && quantity != ColumnQuantity::none &&
            giveAxisUnit(numeric, quantity, unitOf(units.front())))
          continue;
        // LabVIEW lists the units of its channels, without that of the first column.
        const std::size_t before =
            units.size() + 1 == numeric.size() && quantity == ColumnQuantity::forceWeak ? 1 : 0;
        if (units.size() + before != numeric.size()) continue;
        for (std::size_t i = 0; i < units.size(); ++i)
          if (numeric[i + before]->unit.kind == ColumnUnit::Kind::none)
            numeric[i + before]->unit = unitOf(units[i]);
        continue;
      }
      for (DataColumn& column : data_.columns)
        if (column.unit.kind == ColumnUnit::Kind::none && quantityOf(knownWordsIn(column.title)) == quantity)
          column.unit = unitOf(value);
    }
  }

  /// Reads a scale as the column's unit, such as "CH2 load cell 1 V = 0.5 N". Returns true if the cell states
  /// one.
  bool readScale(std::string_view cell, DataColumn& column) const {
    const std::size_t sign = cell.find('=');
    if (sign == std::string_view::npos) return false;
    const std::string_view left = trimmed(cell.substr(0, sign));
    const auto measured = numberIn(trimmed(cell.substr(sign + 1)), table_.style);
    const std::size_t blank = left.find_last_of(' ');
    if (!measured || !(measured->value > 0) || blank == std::string_view::npos) return false;
    const ColumnUnit unit = unitOf(measured->rest);
    if (!unit.isOfButton()) return false;
    const std::size_t before = left.find_last_of(' ', blank - 1);
    const auto from = numberIn(left.substr(before == std::string_view::npos ? 0 : before + 1), table_.style);
    if (!from || !(from->value > 0) || from->rest.empty()) return false;
    column.unit = {unit.kind, unit.size * measured->value / from->value, std::string(measured->rest)};
    column.ratioGiven = true;
    if (before != std::string_view::npos)
      column.title = std::string(left.substr(0, before)) + (column.title.empty() ? "" : " " + column.title);
    return true;
  }

  /// Gives the unit of a line such as "X unit: mm" to a column: to the one titled X; else to the only one
  /// that measures the unit's quantity; else, for X, to the first of two columns. Returns false if there is
  /// no such column.
  static bool giveAxisUnit(const std::vector<DataColumn*>& numeric, ColumnQuantity axis,
                           const ColumnUnit& unit) {
    const auto only = [&](ColumnQuantity quantity) {
      DataColumn* found = nullptr;
      for (DataColumn* column : numeric)
        if (quantityOf(knownWordsIn(column->title)) == quantity) {
          if (found) return static_cast<DataColumn*>(nullptr);
          found = column;
        }
      return found;
    };
    DataColumn* column = only(axis);
    if (!column && unit.kind == ColumnUnit::Kind::displacement) column = only(ColumnQuantity::displacement);
    if (!column && unit.kind == ColumnUnit::Kind::force) column = only(ColumnQuantity::force);
    if (!column && axis == ColumnQuantity::displacementWeak && numeric.size() == 2) column = numeric.front();
    if (!column) return false;
    if (column->unit.kind == ColumnUnit::Kind::none) column->unit = unit;
    return true;
  }

  /// Reads a ratio as a column's unit: "counts_per_newton = 25000", "mm per step: 0.00125".
  void readRatio(std::string_view name, std::string_view value) {
    std::string plain(name);
    std::ranges::replace(plain, '_', ' ');
    std::ranges::replace(plain, '/', ' ');
    const std::size_t per = lowered(plain).find(" per ");
    const auto number = numberIn(value.substr(0, value.find(' ')), table_.style);
    if (per == std::string::npos || !number || !(number->value > 0)) return;
    const std::string above = lowered(trimmed(std::string_view(plain).substr(0, per)));
    const std::string below(trimmed(std::string_view(plain).substr(per + 5)));
    const auto singular = [](std::string word) {
      if (word.size() > 3 && word.back() == 's') word.pop_back();
      return word;
    };
    for (DataColumn& column : data_.columns) {
      const std::string title = singular(lowered(column.title.empty() ? column.unit.text : column.title));
      if (title.empty() || column.unit.isOfButton()) continue;
      const ColumnUnit over = unitOf(above), under = unitOf(below);
      if (under.isOfButton() && title.find(singular(above)) != std::string::npos)
        column.unit = {under.kind, under.size / number->value, under.text};
      else if (over.isOfButton() && title.find(singular(lowered(below))) != std::string::npos)
        column.unit = {over.kind, over.size * number->value, over.text};
      else
        continue;
      column.ratioGiven = true;
    }
  }

  /// For a title in which the words for tables name no quantity, tries the words for charts.
  static void settleName(DataColumn& column) {
    if (column.quantity != ColumnQuantity::none || column.title.empty()) return;
    // "Sample A" names a record, "Samples" is a count.
    if (column.words.has(ColumnWord::record) && column.words.words.size() + column.words.unknown > 1) return;
    const Quantity named = quantityNamedIn(outsideBrackets(column.title), TextSource::exact).quantity;
    column.isUnknownName = named == Quantity::none && column.words.unknown > 0 && column.words.words.empty();
    if (named == Quantity::other) column.quantity = ColumnQuantity::other;
    if (named == Quantity::force) column.quantity = ColumnQuantity::force;
    if (named == Quantity::travel) column.quantity = ColumnQuantity::displacement;
  }

  /// A word such as "charge" names a force or a displacement in one language and another quantity in another.
  /// The other quantity is dropped; if the column has no unit, its name counts as unknown.
  static void settleSharedWords(DataColumn& column) {
    constexpr auto other = static_cast<std::uint32_t>(ColumnWord::other);
    for (KnownWords::Word& word : column.words.words) {
      const bool isShared = word.has(ColumnWord::force) || word.has(ColumnWord::displacement);
      if (!isShared || !word.has(ColumnWord::other)) continue;
      word.meanings &= ~other;
      column.isUnknownName = column.unit.kind == ColumnUnit::Kind::none;
    }
  }

  static void settle(DataColumn& column) {
    column.words = knownWordsIn(outsideBrackets(column.title));
    column.groupWords = knownWordsIn(outsideBrackets(splitTitle(column.group).name));
    column.quantity = quantityOf(column.words);
    settleName(column);
    // The group heading applies if the column's own title names neither quantity nor unit.
    if (column.quantity == ColumnQuantity::none && column.unit.kind == ColumnUnit::Kind::none &&
        !column.group.empty()) {
      column.quantity = quantityOf(column.groupWords);
      const ColumnUnit unit = splitTitle(column.group).unit;
      if (unit.isOfButton() || unit.kind == ColumnUnit::Kind::time) column.unit = unit;
    }
    // A word that can name both a stroke and a quantity ("load", "compression") names the stroke if the unit
    // measures another quantity.
    if (column.unit.kind == ColumnUnit::Kind::displacement && column.quantity == ColumnQuantity::force &&
        column.words.has(ColumnWord::displacement))
      column.quantity = ColumnQuantity::displacement;
    if (column.unit.kind == ColumnUnit::Kind::force && column.quantity == ColumnQuantity::displacement &&
        (column.words.has(ColumnWord::force) || column.words.has(ColumnWord::press)))
      column.quantity = column.words.has(ColumnWord::force) ? ColumnQuantity::force : ColumnQuantity::none;
    // Ounces are a unit of force only if the title names a force.
    if (lowered(column.unit.text) == "oz" && !column.title.empty() && !column.has(ColumnWord::force) &&
        !column.has(ColumnWord::forceWeak))
      column.unit.kind = ColumnUnit::Kind::unknown;
    settleSharedWords(column);
    settleRecordName(column);
    weigh(column);
  }

  /// Marks a title that names a condition instead of a quantity: "0 cycles (N)" is not a number of cycles.
  static void settleRecordName(DataColumn& column) {
    using Kind = ColumnUnit::Kind;
    column.namesRecord =
        (column.unit.kind == Kind::none || column.unit.kind == Kind::force) && namesRecordIn(column);
    if (!column.namesRecord || (column.unit.kind == Kind::none && !isCondition(column.title))) return;
    std::erase_if(column.words.words, [](const KnownWords::Word& word) {
      return !word.has(ColumnWord::record) && !word.has(ColumnWord::press) && !word.has(ColumnWord::release);
    });
    column.quantity = ColumnQuantity::none;
  }

  const Table& table_;
  std::vector<RowFacts> facts_;
  std::vector<std::vector<double>> numbers_;
  std::vector<int> decimals_;
  std::size_t width_ = 0, mainFrom_ = 0, mainTo_ = 0;
  std::vector<std::size_t> core_, numeric_, text_;
  std::pair<std::size_t, std::size_t> heading_{0, 0};
  DataTable data_;
};

/// Returns true if columns were written as rows: a few rows that each begin with a name and continue with
/// numbers.
bool isTransposed(const Table& table) {
  constexpr std::size_t mostRows = 12, fewestColumns = 13;
  std::size_t named = 0, filled = 0;
  for (std::size_t row = 0; row < table.rows() && filled <= mostRows; ++row) {
    filled += !joinedCells(table, row).empty();
    if (table.cells(row) < fewestColumns) continue;
    std::size_t numbers = 0;
    for (std::size_t c = 1; c < table.cells(row); ++c) numbers += table.number(row, c).has_value();
    named +=
        !table.cell(row, 0).empty() && !table.number(row, 0) && numbers * 10 >= (table.cells(row) - 1) * 8;
  }
  return named >= 2 && filled <= mostRows && named * 2 >= filled;
}

}  // namespace

std::string DataColumn::label() const {
  std::string text = std::to_string(index + 1);
  std::string name = group.empty() || title.find(group) != std::string::npos ? title : group + ": " + title;
  if (!unit.text.empty() && unit.text != name) name += name.empty() ? unit.text : " (" + unit.text + ")";
  return name.empty() ? text : text + " \"" + name + "\"";
}

void giveUnit(DataColumn& column, ColumnUnit unit) {
  column.unit = std::move(unit);
  weigh(column);
}

std::optional<DataTable> dataIn(const Table& table) {
  return isTransposed(table) ? ColumnFinder(table.transposed()).find() : ColumnFinder(table).find();
}

}  // namespace detent::importer
