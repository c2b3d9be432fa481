// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/log_columns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/text.h"

namespace detent::importer {
namespace {

enum class Role { displacement, force, label, time, other, unknown };

bool isLetter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
}

/// Runs of letters, in order; "force_gf" gives "force", "gf". Case is kept: it matters in "mN".
std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && isLetter(text[end])) ++end;
    if (end > i) words.emplace_back(text.substr(i, end - i));
    i = std::max(end, i + 1);
  }
  return words;
}

/// "Weg in Schritten": the word before the unit, not inches, which end a title or stand in brackets.
std::string withoutPreposition(std::string_view title) {
  std::string rest(title);
  for (std::size_t at = rest.find(" in "); at != std::string::npos; at = rest.find(" in ", at + 1)) {
    const std::size_t next = rest.find_first_not_of(' ', at + 4);
    if (next != std::string::npos) rest.replace(at, 3, "   ");
  }
  return rest;
}

bool containsAny(const std::string& text, const std::vector<std::string_view>& parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return text.find(part) != std::string::npos; });
}

/// Words of a few letters must stand alone: "pos" is a position, "position" too, but "composite" is none.
bool hasWord(const std::vector<std::string>& words, const std::vector<std::string_view>& wanted) {
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::find(wanted.begin(), wanted.end(), std::string_view(word)) != wanted.end();
  });
}

const std::vector<std::string_view> forceParts{"force", "load", "kraft", "gewicht", "力",   "荷重",  "载荷",
                                               "載荷",  "负荷", "負荷",  "压强",    "圧力", "weight"};
const std::vector<std::string_view> displacementParts{
    "displacement", "position",     "travel",     "distance", "deflection", "extension",
    "compression",  "depth",        "elongation", "weg",      "hub",        "verformung",
    "auslenkung",   "verschiebung", "行程",       "位移",     "距离",       "距離",
    "位置",         "変位",         "変形",       "移動量",   "ストローク", "压缩量"};
const std::vector<std::string_view> timeParts{"time", "zeit",    "时间", "時間", "时刻",
                                              "時刻", "elapsed", "date", "datum"};

Role roleOf(std::string_view title) {
  const std::string low = lowered(title);
  const std::vector<std::string> words = wordsOf(low);
  if (low.empty()) return Role::unknown;
  if (containsAny(low, timeParts)) return Role::time;
  if (containsAny(low, forceParts) || hasWord(words, {"f", "fz", "kraft"})) return Role::force;
  if (containsAny(low, displacementParts) || hasWord(words, {"pos", "disp", "dist", "x", "z", "stroke"}))
    return Role::displacement;
  for (const std::string& word : wordsOf(withoutPreposition(title))) {
    if (forceUnitFrom(word)) return Role::force;
    if (lengthUnitFrom(word)) return Role::displacement;
  }
  if (hasWord(words, {"s", "sec", "seconds", "ms", "t"})) return Role::time;
  if (hasWord(words, {"index", "sample", "no", "nr", "point", "reading", "cycle", "row", "id"}))
    return Role::other;
  return Role::unknown;
}

/// The last word that names a unit: "Weg in mm" is in millimetres.
template <class Unit, class From>
std::optional<Unit> lastUnit(std::string_view title, From from) {
  std::optional<Unit> unit;
  for (const std::string& word : wordsOf(withoutPreposition(title)))
    if (const auto named = from(word)) unit = named;
  return unit;
}

struct ColumnFacts {
  std::string title;
  Role role = Role::unknown;
  bool isLabel = false;
  std::vector<double> values;  ///< finite numbers of the first rows
};

bool isNumberRow(const std::vector<std::string_view>& cells, char decimalSign) {
  int numbers = 0;
  for (std::string_view cell : cells) numbers += wholeNumberIn(cell, decimalSign).has_value();
  return numbers >= 2;
}

/// The first row of a run of number rows (a preamble may hold a lone one, "Version 2.1; 2024").
std::optional<std::size_t> firstNumberRow(const std::vector<std::string>& lines, TableFormat format) {
  std::vector<std::string_view> cells;
  std::vector<char> isRow;
  for (const std::string& line : lines) {
    splitCells(line, format.delimiter, cells);
    isRow.push_back(isNumberRow(cells, format.decimalSign));
  }
  const auto rows = std::count(isRow.begin(), isRow.end(), 1);
  if (rows == 0) return std::nullopt;
  const std::size_t needed = std::min<std::size_t>(3, static_cast<std::size_t>(rows));
  std::size_t run = 0;
  for (std::size_t i = 0; i < isRow.size(); ++i) {
    run = isRow[i] ? run + 1 : 0;
    if (run < needed) continue;
    std::size_t first = i + 1 - needed;
    // A row without numbers among the first ("--;--") is no header where rows of numbers stand above it.
    const auto bridges = [&](std::size_t row) {
      return isRow[row] || (row > 0 && isRow[row - 1] && std::ranges::none_of(lines[row], isLetter));
    };
    while (first > 0 && bridges(first - 1)) --first;
    return first;
  }
  return static_cast<std::size_t>(std::find(isRow.begin(), isRow.end(), 1) - isRow.begin());
}

/// Header words above the numbers: the nearest line with a known role, and a line of units below it.
void nameColumns(std::vector<ColumnFacts>& columns, const std::vector<std::string>& lines, TableFormat format,
                 std::size_t firstRow, std::string& header) {
  std::vector<std::string_view> cells;
  std::vector<std::string> below(columns.size());
  for (std::size_t back = 1; back <= std::min<std::size_t>(4, firstRow); ++back) {
    const std::string& line = lines[firstRow - back];
    splitCells(line, format.delimiter, cells);
    // Titles with blanks in a table set by blanks cannot be told apart by column.
    if (cells.size() > columns.size() && format.delimiter == ' ') cells.clear();
    int known = 0;
    for (std::string_view cell : cells) {
      const Role role = roleOf(cell);
      known += role == Role::displacement || role == Role::force;
    }
    const bool unitsOnly = std::all_of(cells.begin(), cells.end(), [](std::string_view cell) {
      const std::vector<std::string> words = wordsOf(cell);
      return words.empty() || (words.size() == 1 && (forceUnitFrom(words[0]) || lengthUnitFrom(words[0]) ||
                                                     words[0] == "s" || words[0] == "ms"));
    });
    for (std::size_t c = 0; c < std::min(cells.size(), columns.size()); ++c)
      below[c] = std::string(cells[c]) + (below[c].empty() ? "" : " " + below[c]);
    if (unitsOnly && back < std::min<std::size_t>(4, firstRow)) continue;
    if (known == 0) {
      if (unitsOnly) continue;
      break;
    }
    header = line;
    break;
  }
  if (header.empty() && std::none_of(below.begin(), below.end(), [](const std::string& t) {
        return roleOf(t) == Role::force || roleOf(t) == Role::displacement;
      }))
    return;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    columns[c].title = below[c];
    columns[c].role = roleOf(below[c]);
  }
}

/// Share of steps that go the way most steps go, over stretches: 1 for a motor's position, 0.5 for noise.
double steadiness(const std::vector<double>& values) {
  if (values.size() < 3) return 0;
  std::size_t kept = 0, counted = 0;
  double last = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step == 0) continue;
    if (last != 0) ++counted, kept += step * last > 0;
    last = step;
  }
  return counted ? static_cast<double>(kept) / static_cast<double>(counted) : 0;
}

/// A clock or row number: every step up, all alike, while more than two columns are there to choose from.
bool isCounter(const std::vector<double>& values) {
  if (values.size() < 3) return false;
  const double step = values[1] - values[0];
  if (!(step > 0)) return false;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (std::abs(values[i] - values[i - 1] - step) > 0.01 * step) return false;
  return true;
}

void guessRoles(std::vector<ColumnFacts>& columns) {
  std::vector<std::size_t> open;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].role == Role::unknown && !columns[c].values.empty()) open.push_back(c);
  const auto has = [&](Role role) {
    return std::any_of(columns.begin(), columns.end(), [&](const ColumnFacts& f) { return f.role == role; });
  };
  const std::size_t missing = (has(Role::displacement) ? 0u : 1u) + (has(Role::force) ? 0u : 1u);
  while (open.size() > missing && isCounter(columns[open.front()].values)) open.erase(open.begin());
  if (!has(Role::displacement) && !has(Role::force)) {
    if (open.size() < 2) return;
    std::size_t x = open[0], f = open[1];
    // Displacement comes first as a rule; over enough rows a much steadier second column overrules it.
    const bool enough = columns[x].values.size() >= 20;
    if (enough && steadiness(columns[f].values) > steadiness(columns[x].values) + 0.2) std::swap(x, f);
    columns[x].role = Role::displacement;
    columns[f].role = Role::force;
    if (open.size() == 4) columns[open[2]].role = columns[x].role, columns[open[3]].role = columns[f].role;
    return;
  }
  for (const std::size_t c : open) {
    if (!has(Role::displacement))
      columns[c].role = Role::displacement;
    else if (!has(Role::force))
      columns[c].role = Role::force;
  }
}

/// A stroke's name and no more: a switch may be called "Sunny Side Up Linear".
bool isStrokeLabel(std::string_view cell) {
  constexpr std::size_t mostWords = 2;  // "press stroke"
  return wordsOf(cell).size() <= mostWords && strokeNamed(cell).has_value();
}

/// Units of all columns in a line of the preamble, "UNIT = gf,mm"; empty where no line has them.
std::vector<std::string> unitsAbove(const std::vector<std::string>& lines, TableFormat format,
                                    std::size_t firstRow, std::size_t columns) {
  std::vector<std::string_view> cells;
  for (std::size_t i = 0; i < firstRow; ++i) {
    splitCells(lines[i], format.delimiter, cells);
    if (cells.size() != columns || !lowered(cells.front()).starts_with("unit")) continue;
    std::vector<std::string> units;
    for (const std::string_view cell : cells)
      units.emplace_back(trimmed(cell.substr(cell.find_last_of(":= ") + 1)));
    return units;
  }
  return {};
}

std::vector<ColumnPair> pairsOf(const std::vector<ColumnFacts>& columns) {
  std::vector<std::size_t> xs, fs;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].role == Role::displacement) xs.push_back(c);
    if (columns[c].role == Role::force) fs.push_back(c);
  }
  std::vector<ColumnPair> pairs;
  if (xs.empty() || fs.empty()) return pairs;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, fs.size()); ++i) {
    ColumnPair pair{xs[std::min(i, xs.size() - 1)], fs[i], {}};
    pair.stroke = strokeNamed(columns[pair.force].title);
    if (!pair.stroke) pair.stroke = strokeNamed(columns[pair.displacement].title);
    pairs.push_back(pair);
  }
  // Two forces without a word about strokes beside one displacement: a second channel, not a second stroke.
  const bool told = pairs.size() == 2 && (pairs[0].stroke || pairs[1].stroke);
  if (pairs.size() == 2 && xs.size() == 1 && !told) pairs.resize(1);
  if (pairs.size() == 2) {
    if (!pairs[0].stroke)
      pairs[0].stroke = pairs[1].stroke == Stroke::press ? Stroke::release : Stroke::press;
    if (!pairs[1].stroke || pairs[1].stroke == pairs[0].stroke)
      pairs[1].stroke = pairs[0].stroke == Stroke::press ? Stroke::release : Stroke::press;
  }
  return pairs;
}

double secondsOf(std::string_view title) {
  double seconds = 1;
  for (const std::string& word : wordsOf(lowered(title))) {
    if (word == "ms" || word == "msec") seconds = 1e-3;
    if (word == "us" || word == "µs" || word == "μs") seconds = 1e-6;
    if (word == "min") seconds = 60;
  }
  return seconds;
}

}  // namespace

std::optional<Stroke> strokeNamed(std::string_view text) {
  const std::string low = lowered(text);
  const std::vector<std::string> words = wordsOf(low);
  // Release first: "decompression" holds "compression", "unloading" holds "loading".
  if (containsAny(low, {"release", "upstroke", "return", "unload", "decompress", "rück", "loslassen",
                        "entlast", "释放", "回弹", "回程", "抬起", "戻り", "復路", "除荷", "離す"}) ||
      hasWord(words, {"up", "back", "zurück", "rel"}))
    return Stroke::release;
  if (containsAny(low, {"press", "downstroke", "loading", "betätig", "belast", "drück", "hinweg", "按下",
                        "压下", "下压", "去程", "押し", "往路"}) ||
      hasWord(words, {"down", "forward", "hin"}))
    return Stroke::press;
  return std::nullopt;
}

std::optional<LogColumns> columnsOf(const std::vector<std::string>& lines, TableFormat format) {
  const auto firstRow = firstNumberRow(lines, format);
  if (!firstRow) return std::nullopt;
  LogColumns found;
  found.firstRow = *firstRow;
  std::vector<ColumnFacts> columns;
  std::vector<std::string_view> cells;
  for (std::size_t i = *firstRow; i < lines.size(); ++i) {
    splitCells(lines[i], format.delimiter, cells);
    if (!isNumberRow(cells, format.decimalSign)) continue;
    if (columns.size() < cells.size()) columns.resize(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto number = wholeNumberIn(cells[c], format.decimalSign);
      if (number && std::isfinite(*number)) columns[c].values.push_back(*number);
      if (!number && isStrokeLabel(cells[c])) columns[c].isLabel = true;
    }
  }
  nameColumns(columns, lines, format, *firstRow, found.header);
  const std::vector<std::string> units = unitsAbove(lines, format, *firstRow, columns.size());
  for (std::size_t c = 0; c < units.size(); ++c) {
    columns[c].title += " " + units[c];
    if (forceUnitFrom(units[c])) columns[c].role = Role::force;
    if (lengthUnitFrom(units[c])) columns[c].role = Role::displacement;
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].isLabel) found.label = c, columns[c].role = Role::label;
    if (columns[c].values.empty() && columns[c].role != Role::label) columns[c].role = Role::other;
  }
  guessRoles(columns);
  for (std::size_t c = 0; c < columns.size() && !found.time; ++c)
    if (columns[c].role == Role::time) found.time = c, found.secondsPerTime = secondsOf(columns[c].title);
  found.pairs = pairsOf(columns);
  if (found.pairs.empty()) return std::nullopt;
  if (found.label) found.pairs.resize(1);

  const ColumnPair& pair = found.pairs.front();
  // Units stand in the title, in the line below it, or behind the numbers.
  splitCells(lines[*firstRow], format.delimiter, cells);
  const auto restOf = [&](std::size_t column) {
    const auto number = column < cells.size() ? numberIn(cells[column], format.decimalSign) : std::nullopt;
    return number ? std::string(number->rest) : std::string();
  };
  found.xUnit = lastUnit<LengthUnit>(columns[pair.displacement].title,
                                     [](const std::string& w) { return lengthUnitFrom(w); });
  found.yUnit =
      lastUnit<ForceUnit>(columns[pair.force].title, [](const std::string& w) { return forceUnitFrom(w); });
  if (!found.xUnit) found.xUnit = lengthUnitFrom(restOf(pair.displacement));
  if (!found.yUnit) found.yUnit = forceUnitFrom(restOf(pair.force));
  return found;
}

}  // namespace detent::importer
