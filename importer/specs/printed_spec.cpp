// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/specs/printed_spec.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <regex>
#include <string_view>

#include "model/sections.h"
#include "model/units.h"

namespace detent::importer {
namespace {

struct Phrases {
  SpecQuantity quantity;
  std::array<std::string_view, 9> words;  // empty ones at the end
};

// As datasheets print them, lower case, without spaces. Longer ones first: "pressurepointforce" is not "force".
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

/// ASCII lower case without spaces; other UTF-8 untouched. `from`: where each byte stood in the text.
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

/// A quantity and where in the row its name ends.
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
    if (rest.starts_with('(') || rest.starts_with("\xEF\xBC\x88"))  // full-width (
      return ending(0, quantity, word);
  }
  return {};
}

double numberFrom(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The unit of a quantity's kind that the row prints, as a factor to mm or N.
std::optional<double> factorIn(const std::string& row, SpecQuantity quantity) {
  static const std::regex unitWord(R"((^|[^A-Za-z])(mm|cN|mN|gf|g|N|ozf?|in|inch)(?![A-Za-z]))");
  for (std::sregex_iterator it(row.begin(), row.end(), unitWord), end; it != end; ++it) {
    const std::string symbol = (*it)[2];
    if (measuredInNewton(quantity)) {
      if (const auto unit = forceUnitFrom(symbol)) return newtonsPer(*unit);
    } else if (const auto unit = lengthUnitFrom(symbol)) {
      return millimetresPer(*unit);
    }
  }
  return {};
}

/// "55 ± 25", "4.0 -0.4", "30 cN min.", "3.5": nominal and bounds, in the printed unit.
std::optional<PrintedSpec> valuesIn(const std::string& row) {
  static const std::string number = R"((\d+(?:[.,]\d+)?))";
  static const std::regex plusMinus(number + R"(\s*[A-Za-z]{0,3}\s*(?:±|\+/-|\+-)\s*)" + number);
  static const std::regex minusOnly(number + R"(\s*(?:-|–|−)\s*)" + number);
  static const std::regex single(number);
  PrintedSpec spec;
  std::smatch found;
  if (std::regex_search(row, found, plusMinus)) {
    spec.nominal = numberFrom(found[1]);
    spec.smallest = spec.nominal - numberFrom(found[2]);
    spec.largest = spec.nominal + numberFrom(found[2]);
    return spec;
  }
  if (std::regex_search(row, found, minusOnly)) {  // "4.0 -0.4" is 3.6 to 4.0, "3.5-4.1" a range
    const double first = numberFrom(found[1]), second = numberFrom(found[2]);
    spec.nominal = first;
    spec.smallest = second < first ? first - second : first;
    spec.largest = std::max(first, second);
    return spec;
  }
  if (!std::regex_search(row, found, single)) return {};
  spec.nominal = numberFrom(found[1]);
  const std::string text = squeezed(row).text;
  if (text.find("min") != std::string::npos) spec.smallest = spec.nominal;
  if (text.find("max") != std::string::npos) spec.largest = spec.nominal;
  return spec;
}

/// The values of a row with a column per variant of the product, "3.0 ± 0.4 4.0 ± 0.4 mm": every one in the row's unit. With
/// words of bounds, which belong to one value, and where a number has another unit or is no value: the first alone.
std::vector<PrintedSpec> variantsIn(const std::string& row, SpecQuantity quantity, double rowFactor) {
  const auto first = valuesIn(row);
  if (!first) return {};
  const std::string text = squeezed(row).text;
  if (text.find("min") != std::string::npos || text.find("max") != std::string::npos) return {*first};
  static const std::regex value(
      R"((\d+(?:[.,]\d+)?)\s*([A-Za-z]*)(\s*(?:±|\+/-|\+-|-|–|−)\s*\d+(?:[.,]\d+)?)?\s*([A-Za-z]*))");
  std::vector<PrintedSpec> variants;
  for (std::sregex_iterator it(row.begin(), row.end(), value), end; it != end; ++it) {
    for (const std::size_t word : {std::size_t{2}, std::size_t{4}}) {
      const std::string unit = (*it)[word];
      if (!unit.empty() && factorIn(" " + unit, quantity) != rowFactor) return {*first};
    }
    const auto spec = valuesIn(it->str());
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
      return Message("pretravel");
    case SpecQuantity::operatingForce:
      return Message("operating force");
    case SpecQuantity::tactileForce:
      return Message("tactile force");
    case SpecQuantity::endForce:
      return Message("end force");
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

/// Variants of one product: one line of the page.
bool ofOneRow(const PrintedSpec& a, const PrintedSpec& b) {
  return a.quantity == b.quantity && a.page == b.page && a.text == b.text;
}

/// The variant that the graph is of is the one it agrees with, else the nearest.
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
  return check.agrees ? Message("agrees with the page: %1 %2 read, %3 printed (page %4: \"%5\")", quantity,
                                read, printed, spec.page, spec.text)
                      : Message("differs from the page: %1 %2 read, %3 printed (page %4: \"%5\")", quantity,
                                read, printed, spec.page, spec.text);
}

std::vector<PrintedSpec> readPrintedSpecs(const Page& page) {
  std::vector<PrintedSpec> specs;
  for (const std::string& row : rowsOf(page)) {
    if (row.size() > 300) continue;  // running text, not a row of a table
    const auto named = quantityNamedIn(row);
    if (!named) continue;
    const auto factor = factorIn(row, named->quantity);
    // What stands before the name is the row's number, unless nothing stands after it.
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
  // A graph is drawn, not measured: reading it cannot be better than a percent or so.
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
