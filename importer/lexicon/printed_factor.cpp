// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/printed_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "importer/lexicon/lexicon.h"
#include "model/units.h"

namespace detent::importer {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isUnitLetter(char c) {
  return static_cast<unsigned char>(c) >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Takes one of the tokens off the text's beginning; returns its index, or their number if none stands there.
template <std::size_t count>
std::size_t take(std::string_view& text, const std::array<std::string_view, count>& tokens) {
  for (std::size_t i = 0; i < count; ++i)
    if (text.starts_with(tokens[i])) {
      text.remove_prefix(tokens[i].size());
      return i;
    }
  return count;
}

bool take(std::string_view& text, std::string_view token) { return take(text, std::array{token}) == 0; }

void takeBlanks(std::string_view& text) {
  while (take(text, std::array<std::string_view, 2>{" ", "\xC2\xA0"}) < 2) {
  }
}

std::size_t takeZeros(std::string_view& text) {
  std::size_t zeros = 0;
  while (take(text, "0")) ++zeros;
  return zeros;
}

/// Takes the exponent behind a ten; nullopt without one. `afterSign`: a plain digit may be a raised one, as
/// recognisers read "×10³".
std::optional<int> takeExponent(std::string_view& text, bool afterSign) {
  constexpr std::array<std::string_view, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  constexpr std::array<std::string_view, 4> minus{"-", "−", "–", "⁻"};
  std::string_view rest = text;
  const bool marked = take(rest, "^") || take(rest, "e") || take(rest, "E");
  const bool inBraces = marked && take(rest, "{");
  const bool negative = take(rest, minus) < minus.size();
  std::size_t digit = take(rest, raised);
  if (digit == raised.size()) {
    if (rest.empty() || !isDigit(rest.front()) || !(marked || negative || afterSign)) return {};
    digit = static_cast<std::size_t>(rest.front() - '0');
    rest.remove_prefix(1);
  }
  if (inBraces && !take(rest, "}")) return {};
  text = rest;
  return negative ? -static_cast<int>(digit) : static_cast<int>(digit);
}

/// Takes a power of ten: "100", "0.01", "1/100", "10^-3", "10³", "1e3".
std::optional<double> takePower(std::string_view& text, bool afterSign) {
  std::string_view rest = text;
  int power = 0;
  if (take(rest, "0.") || take(rest, "0,")) {
    power = -1 - static_cast<int>(takeZeros(rest));
    if (!take(rest, "1")) return {};
  } else if (take(rest, "1/1")) {
    power = -static_cast<int>(takeZeros(rest));
  } else if (take(rest, "1")) {
    power = static_cast<int>(takeZeros(rest));
    const bool isOne = power == 0;
    if (isOne && !rest.starts_with('e') && !rest.starts_with('E')) return {};
    if (power <= 1) {
      const auto exponent = takeExponent(rest, afterSign && !isOne);
      if (isOne && !exponent) return {};
      if (exponent) power = *exponent;
    }
  } else {
    return {};
  }
  const bool goesOn =
      !rest.empty() &&
      (isDigit(rest.front()) || ((rest[0] == '.' || rest[0] == ',') && rest.size() > 1 && isDigit(rest[1])));
  if (power == 0 || goesOn) return {};
  text = rest;
  return std::pow(10.0, power);
}

/// Takes a sign of multiplication. A letter x is one only where it stands alone.
bool takeSign(std::string_view title, std::size_t at, std::string_view& rest) {
  constexpr std::array<std::string_view, 5> signs{"×", "·", "∙", "⋅", "*"};
  if (take(rest, signs) < signs.size()) return true;
  const bool alone = at == 0 || !(isUnitLetter(title[at - 1]) || isDigit(title[at - 1]));
  return alone && (take(rest, "x") || take(rest, "X"));
}

/// Takes what stands in front of a unit where only units stand: a bracket, a slash, or "in".
bool takePlace(std::string_view title, std::string_view& rest) {
  if (take(rest, std::array<std::string_view, 3>{"(", "[", "{"}) < 3 || take(rest, " in ")) return true;
  return title.find_first_of("([{") == std::string_view::npos && take(rest, "/");
}

/// Returns true if a unit begins the text and nothing but a bracket or a blank follows.
bool beginsWithUnit(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, isUnitLetter);
  const std::string unit(text.begin(), end);
  if (unit.empty() || (end != text.end() && std::string_view(" )]}|").find(*end) == std::string_view::npos))
    return false;
  return forceUnitFrom(unit) || lengthUnitFrom(unit) || unitReadAs(unit, TextSource::recognised, false);
}

}  // namespace

std::optional<PrintedFactor> printedFactorIn(std::string_view title) {
  for (std::size_t at = 0; at < title.size(); ++at) {
    std::string_view rest = title.substr(at);
    const bool afterSign = takeSign(title, at, rest);
    if (!afterSign && !takePlace(title, rest)) continue;
    const std::size_t from = afterSign ? at : title.size() - rest.size();
    takeBlanks(rest);
    const auto factor = takePower(rest, afterSign);
    if (!factor) continue;
    const std::string_view behind = rest;
    takeBlanks(rest);
    if (!afterSign && !beginsWithUnit(rest)) continue;
    PrintedFactor found{*factor, std::string(title.substr(0, from)) + std::string(behind)};
    return std::ranges::any_of(found.title, isUnitLetter) ? std::optional(std::move(found)) : std::nullopt;
  }
  return {};
}

}  // namespace detent::importer
