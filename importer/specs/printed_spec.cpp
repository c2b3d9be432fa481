// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/specs/printed_spec.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "model/sections.h"
#include "model/units.h"

namespace detent::importer {
namespace {

struct Phrases {
  SpecQuantity quantity;
  std::array<std::string_view, 9> words;  // unused ones at the end are empty
};

// Phrases of datasheets in lower case without spaces. Longer ones come first: "pressurepointforce" must not
// match "force".
constexpr Phrases phrases[] = {
    {SpecQuantity::tactileForce, {"pressurepointforce", "tactileforce", "druckpunktkraft", "触感力"}},
    {SpecQuantity::endForce, {"totaltravelforce", "endforce", "endkraft"}},
    {SpecQuantity::totalTravel,
     {"totaltravel", "fulltravel", "actuatortravel", "totalstroke", "fullstroke", "gesamtweg", "总行程",
      "全行程", "全ストローク"}},
    {SpecQuantity::preTravel,
     {"pretravel", "pre-travel", "operatingtravel", "vorlaufweg", "schaltweg", "导通行程", "动作行程"}},
    {SpecQuantity::operatingForce,
     {"operatingforce", "operationforce", "actuationforce", "schaltkraft", "操作力", "动作力"}}};

// Abbreviations count only where the row starts with them: "OF" is also a word.
constexpr Phrases abbreviations[] = {{SpecQuantity::totalTravel, {"tt"}},
                                     {SpecQuantity::preTravel, {"pt"}},
                                     {SpecQuantity::operatingForce, {"of"}},
                                     {SpecQuantity::tactileForce, {"tf"}}};

bool measuredInNewton(SpecQuantity quantity) {
  return quantity == SpecQuantity::operatingForce || quantity == SpecQuantity::tactileForce ||
         quantity == SpecQuantity::endForce;
}

/// A text in lower case (ASCII) without spaces; other UTF-8 is unchanged. `from`: position of each byte in
/// the original text.
struct Squeezed {
  std::string text;
  std::vector<std::size_t> from;
};

Squeezed squeezed(const std::string& text) {
  Squeezed out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == ' ' || byte == '\t') continue;
    out.text += byte < 128 ? static_cast<char>(std::tolower(byte)) : text[i];
    out.from.push_back(i);
  }
  return out;
}

/// A quantity and the position in the row where its name ends.
struct NamedQuantity {
  SpecQuantity quantity;
  std::size_t end;
};

std::optional<NamedQuantity> quantityNamedIn(const std::string& row) {
  const Squeezed squeezedRow = squeezed(row);
  const std::string& text = squeezedRow.text;
  const auto ending = [&](std::size_t at, SpecQuantity quantity, std::string_view word) {
    return NamedQuantity{quantity, squeezedRow.from[at + word.size() - 1] + 1};
  };
  for (const auto& [quantity, words] : phrases)
    for (const std::string_view word : words) {
      const auto at = word.empty() ? std::string::npos : text.find(word);
      if (at != std::string::npos) return ending(at, quantity, word);
    }
  for (const auto& [quantity, words] : abbreviations) {
    const std::string_view word = words.front();
    if (text.rfind(word, 0) != 0) continue;
    const std::string_view rest = std::string_view(text).substr(word.size());
    if (rest.starts_with('(') || rest.starts_with("\xEF\xBC\x88"))  // full-width bracket
      return ending(0, quantity, word);
  }
  return {};
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isAsciiSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Reads a row from left to right. A step that does not match leaves the position unchanged.
struct RowReader {
  std::string_view row;
  std::size_t at = 0;

  bool done() const { return at >= row.size(); }
  void skipSpaces() {
    while (!done() && isAsciiSpace(row[at])) ++at;
  }
  /// The next ASCII letters, at most `most`.
  std::string_view letters(std::size_t most = std::string_view::npos) {
    const std::size_t from = at;
    while (!done() && isAsciiLetter(row[at]) && at - from < most) ++at;
    return row.substr(from, at - from);
  }
  /// "4", "4.0", "4,0".
  std::optional<double> number() {
    const std::size_t from = at;
    while (!done() && isDigit(row[at])) ++at;
    if (at == from) return {};
    if (at + 1 < row.size() && (row[at] == '.' || row[at] == ',') && isDigit(row[at + 1]))
      for (++at; !done() && isDigit(row[at]);) ++at;
    std::string text(row.substr(from, at - from));
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }
  bool oneOf(std::initializer_list<std::string_view> signs) {
    for (const std::string_view sign : signs)
      if (row.substr(at).starts_with(sign)) {
        at += sign.size();
        return true;
      }
    return false;
  }
  bool plusMinus() { return oneOf({"±", "+/-", "+-"}); }
  bool dash() { return oneOf({"-", "–", "−"}); }
  /// Moves to where the next run of digits begins; false at the end of the row.
  bool toNextDigits() {
    while (!done() && (!isDigit(row[at]) || (at > 0 && isDigit(row[at - 1])))) ++at;
    return !done();
  }
};

/// Factor to mm or N of a word that is a unit of the quantity.
std::optional<double> factorOf(std::string_view word, SpecQuantity quantity) {
  constexpr std::array<std::string_view, 10> unitWords{"mm", "cN", "mN",  "gf", "g",
                                                       "N",  "oz", "ozf", "in", "inch"};
  if (std::ranges::find(unitWords, word) == unitWords.end()) return {};
  if (measuredInNewton(quantity)) {
    if (const auto unit = forceUnitFrom(word)) return newtonsPer(*unit);
  } else if (const auto unit = lengthUnitFrom(word)) {
    return millimetresPer(*unit);
  }
  return {};
}

/// Returns true if an "in" behind this text is a unit, not the word: behind a digit or in brackets.
bool isInch(std::string_view before) {
  while (!before.empty() && isAsciiSpace(before.back())) before.remove_suffix(1);
  return !before.empty() && (isDigit(before.back()) || before.back() == '(' || before.back() == '[');
}

/// Factor to mm or N of the first unit in the row that fits the quantity.
std::optional<double> factorIn(std::string_view row, SpecQuantity quantity) {
  for (RowReader reader{row}; !reader.done();) {
    const std::string_view before = row.substr(0, reader.at), word = reader.letters();
    if (word.empty()) {
      ++reader.at;
      continue;
    }
    if (word == "in" && !isInch(before)) continue;
    if (const auto factor = factorOf(word, quantity)) return factor;
  }
  return {};
}

using TwoNumbers = std::pair<double, double>;

/// The first two numbers of the row whose separator `between` accepts.
template <typename Between>
std::optional<TwoNumbers> numbersJoinedBy(std::string_view row, Between between) {
  for (RowReader start{row}; start.toNextDigits(); ++start.at) {
    RowReader reader = start;
    const auto first = reader.number();
    if (!between(reader)) continue;
    reader.skipSpaces();
    if (const auto second = reader.number()) return TwoNumbers{*first, *second};
  }
  return {};
}

/// "55 ± 25", "4.0 -0.4", "30 cN min.", "3.5": nominal and bounds, in the printed unit.
std::optional<PrintedSpec> valuesIn(std::string_view row) {
  PrintedSpec spec;
  const auto plusMinus = [](RowReader& reader) {
    reader.skipSpaces();
    reader.letters(3);  // skips a unit
    reader.skipSpaces();
    return reader.plusMinus();
  };
  if (const auto found = numbersJoinedBy(row, plusMinus)) {
    spec.nominal = found->first;
    spec.smallest = spec.nominal - found->second;
    spec.largest = spec.nominal + found->second;
    return spec;
  }
  const auto plusOnly = [](RowReader& reader) {
    reader.skipSpaces();
    return reader.oneOf({"+"});
  };
  const auto slashMinus = [](RowReader& reader) { return reader.oneOf({"/"}) && reader.dash(); };
  if (const auto found = numbersJoinedBy(row, plusOnly)) {  // "1.7 +0.4/-0.3"
    const auto below = numbersJoinedBy(row, slashMinus);
    spec.nominal = found->first;
    spec.smallest = spec.nominal - (below ? below->second : 0);
    spec.largest = spec.nominal + found->second;
    return spec;
  }
  const auto minusOnly = [](RowReader& reader) {
    reader.skipSpaces();
    return reader.dash();
  };
  if (const auto found = numbersJoinedBy(row, minusOnly)) {  // "4.0 -0.4" is 3.6 to 4.0, "3.5-4.1" a range
    const auto [first, second] = *found;
    spec.nominal = first;
    spec.smallest = second < first ? first - second : first;
    spec.largest = std::max(first, second);
    return spec;
  }
  RowReader reader{row};
  if (!reader.toNextDigits()) return {};
  spec.nominal = *reader.number();
  const std::string text = squeezed(std::string(row)).text;
  if (text.find("min") != std::string::npos) spec.smallest = spec.nominal;
  if (text.find("max") != std::string::npos) spec.largest = spec.nominal;
  return spec;
}

/// The values of a row with one column per variant of the product, "3.0 ± 0.4 4.0 ± 0.4 mm", all in the row's
/// unit. Only the first one if the row has words for bounds, which belong to a single value, or if a number
/// has another unit or is no value.
std::vector<PrintedSpec> variantsIn(const std::string& row, SpecQuantity quantity, double rowFactor) {
  const auto first = valuesIn(row);
  if (!first) return {};
  const std::string text = squeezed(row).text;
  if (text.find("min") != std::string::npos || text.find("max") != std::string::npos) return {*first};
  std::vector<PrintedSpec> variants;
  for (RowReader reader{row}; reader.toNextDigits();) {
    const std::size_t from = reader.at;
    reader.number();
    reader.skipSpaces();
    const std::string_view unit = reader.letters();
    RowReader tolerance = reader;
    tolerance.skipSpaces();
    if (tolerance.plusMinus() || tolerance.dash() || tolerance.oneOf({"+"})) {
      tolerance.skipSpaces();
      if (tolerance.number()) reader = tolerance;
      if (tolerance.oneOf({"/"}) && tolerance.dash() && tolerance.number()) reader = tolerance;
    }
    reader.skipSpaces();
    const std::string_view unitAfter = reader.letters();
    for (const std::string_view word : {unit, unitAfter})
      if (!word.empty() && factorOf(word, quantity) != rowFactor) return {*first};
    const auto spec = valuesIn(std::string_view(row).substr(from, reader.at - from));
    if (!spec || spec->nominal <= 0) return {*first};
    variants.push_back(*spec);
  }
  return variants;
}

/// Text boxes at one height, left to right, as one row.
std::vector<std::string> rowsOf(const Page& page) {
  std::vector<const TextBox*> boxes;
  for (const TextBox& box : page.texts) {
    if (std::abs(box.angle_deg) < 1 && !box.utf8.empty()) boxes.push_back(&box);
  }
  const auto middle = [](const TextBox* b) { return (b->box.y0 + b->box.y1) / 2; };
  std::stable_sort(boxes.begin(), boxes.end(),
                   [&](const TextBox* a, const TextBox* b) { return middle(a) < middle(b); });
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < boxes.size();) {
    std::size_t end = i + 1;
    while (end < boxes.size() && middle(boxes[end]) - middle(boxes[i]) < 0.4 * boxes[i]->box.height()) ++end;
    std::stable_sort(boxes.begin() + static_cast<std::ptrdiff_t>(i),
                     boxes.begin() + static_cast<std::ptrdiff_t>(end),
                     [](const TextBox* a, const TextBox* b) { return a->box.x0 < b->box.x0; });
    std::string row;
    for (; i < end; ++i) row += (row.empty() ? "" : " ") + boxes[i]->utf8;
    rows.push_back(std::move(row));
  }
  return rows;
}

Message nameOf(SpecQuantity quantity) {
  switch (quantity) {
    case SpecQuantity::totalTravel:
      return Message("total travel");
    case SpecQuantity::preTravel:
      return Message("pre-travel");
    case SpecQuantity::operatingForce:
      return Message("operating force");
    case SpecQuantity::tactileForce:
      return Message("peak force");
    case SpecQuantity::endForce:
      return Message("force at the end");
  }
  return {};
}

/// The value the graph shows for a quantity, if it shows one.
std::optional<double> readValue(SpecQuantity quantity, const ButtonState& state) {
  const StrokeCurve& press = state.graph.press();
  switch (quantity) {
    case SpecQuantity::totalTravel:
      return state.graph.travel_mm();
    case SpecQuantity::preTravel:
      return state.operatingPoint_mm;
    case SpecQuantity::operatingForce:
      return state.operatingPoint_mm ? std::optional(press.force_N(*state.operatingPoint_mm)) : std::nullopt;
    case SpecQuantity::tactileForce: {
      const auto points = tactilePoints(press, Stroke::press);
      return points.empty() ? std::nullopt : std::optional(points.front().force_N);
    }
    case SpecQuantity::endForce:
      return press.knots().back().force_N;
  }
  return {};
}

}  // namespace

namespace {

/// Returns true if both values are of one row, that is of variants of one product.
bool ofOneRow(const PrintedSpec& a, const PrintedSpec& b) {
  return a.quantity == b.quantity && a.page == b.page && a.text == b.text;
}

/// The graph's variant is the one that agrees with it, else the nearest.
bool fitsBetter(const SpecCheck& a, const SpecCheck& b) {
  if (a.agrees != b.agrees) return a.agrees;
  return std::abs(a.read - a.spec.nominal) < std::abs(b.read - b.spec.nominal);
}

}  // namespace

bool PrintedSpec::isForce() const { return measuredInNewton(quantity); }

Message messageOf(const SpecCheck& check) {
  const PrintedSpec& spec = check.spec;
  const Measure measure = spec.isForce() ? Measure::force_N : Measure::displacement_mm;
  const Message quantity = nameOf(spec.quantity);
  const MessageValue read(check.read, measure), printed(spec.nominal, measure);
  return check.agrees ? Message("%1 agrees with the page: %2 read, %3 printed (page %4: \"%5\")", quantity,
                                read, printed, spec.page, spec.text)
                      : Message("%1 differs from the page: %2 read, %3 printed (page %4: \"%5\")", quantity,
                                read, printed, spec.page, spec.text);
}

std::vector<PrintedSpec> readPrintedSpecs(const Page& page) {
  std::vector<PrintedSpec> specs;
  for (const std::string& row : rowsOf(page)) {
    if (row.size() > 300) continue;  // running text, not a row of a table
    const auto named = quantityNamedIn(row);
    if (!named) continue;
    const auto factor = factorIn(row, named->quantity);
    // A text before the name is the number of the row, unless no unit follows the name.
    if (!factor) continue;
    auto variants = variantsIn(row.substr(named->end), named->quantity, *factor);
    if (variants.empty()) variants = variantsIn(row, named->quantity, *factor);
    for (PrintedSpec& spec : variants) {
      if (spec.nominal <= 0) continue;
      spec.quantity = named->quantity;
      spec.nominal *= *factor;
      if (spec.smallest) *spec.smallest *= *factor;
      if (spec.largest) *spec.largest *= *factor;
      spec.text = row;
      spec.page = page.number;
      specs.push_back(std::move(spec));
    }
  }
  return specs;
}

std::vector<SpecCheck> checkAgainst(const std::vector<PrintedSpec>& specs, const Button& button) {
  // Least tolerances. A graph is drawn, not measured: reading it is no more accurate than about a percent.
  constexpr double readingShare = 0.015, bareShare = 0.03;
  std::vector<SpecCheck> checks;
  for (const PrintedSpec& spec : specs) {
    const auto read = readValue(spec.quantity, button.states().front());
    if (!read) continue;
    const bool toleranced = spec.smallest || spec.largest;
    const double slack = (toleranced ? readingShare : bareShare) * spec.nominal;
    const double smallest = toleranced ? spec.smallest.value_or(-HUGE_VAL) : spec.nominal;
    const double largest = toleranced ? spec.largest.value_or(HUGE_VAL) : spec.nominal;
    const SpecCheck check{spec, *read, *read >= smallest - slack && *read <= largest + slack};
    if (checks.empty() || !ofOneRow(checks.back().spec, spec))
      checks.push_back(check);
    else if (fitsBetter(check, checks.back()))
      checks.back() = check;
  }
  return checks;
}

}  // namespace detent::importer
