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

constexpr std::array<std::string_view, 4> openers{"(", "[", "{", "（"};

/// Takes what stands in front of a unit where only units stand: a bracket, a slash, or "in".
bool takePlace(std::string_view title, std::string_view& rest) {
  if (take(rest, openers) < openers.size() || take(rest, " in ")) return true;
  return title.find_first_of("([{") == std::string_view::npos && take(rest, "/");
}

/// 1 if the text is the name of a force or a travel, 2 if that is the last of several words; else 0, also if
/// a digit follows.
int wordsUpToQuantity(std::string_view text) {
  const auto isLetter = [](char c) { return isUnitLetter(c); };
  const auto end = std::ranges::find_if(text.rbegin(), text.rend(), isLetter);
  const auto begin = std::find_if_not(end, text.rend(), isLetter);
  if (std::any_of(text.rbegin(), end, isDigit)) return 0;
  const Quantity quantity = quantityNamedIn({begin.base(), end.base()}, TextSource::recognised).quantity;
  if (quantity != Quantity::force && quantity != Quantity::travel) return 0;
  return std::any_of(begin, text.rend(), isLetter) ? 2 : 1;
}

/// Returns true if a number may begin here: no letter, digit, point or slash stands directly in front.
bool mayBeginNumber(std::string_view title, std::size_t at) {
  return at > 0 && isDigit(title[at]) && !isUnitLetter(title[at - 1]) && !isDigit(title[at - 1]) &&
         title[at - 1] != '.' && title[at - 1] != '/';
}

/// Returns true if a unit begins the text and nothing but a bracket or a blank follows.
bool beginsWithUnit(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, isUnitLetter);
  std::string unit(text.begin(), end);
  constexpr std::string_view closer = "）";  // its bytes count as letters
  if (unit.ends_with(closer)) unit.resize(unit.size() - closer.size());
  if (unit.empty() || (end != text.end() && std::string_view(" )]}|").find(*end) == std::string_view::npos))
    return false;
  return forceUnitFrom(unit) || lengthUnitFrom(unit) || unitReadAs(unit, TextSource::recognised, false);
}

/// Takes what was read of an exponent behind a ten, up to the unit or its bracket; true if anything was, and
/// a unit follows.
bool takeUnread(std::string_view& text) {
  const auto isOver = [](std::string_view t) {
    return t.empty() || std::string_view(" ,;([{)]}|").find(t.front()) != std::string_view::npos ||
           beginsWithUnit(t);
  };
  std::string_view rest = text, ahead = text;
  takeBlanks(ahead);
  if (!ahead.empty() && isDigit(ahead.front())) rest = ahead;  // "x10 3 mN"
  while (!isOver(rest)) rest.remove_prefix(1);
  const bool any = rest.size() < text.size();
  text = rest;
  takeBlanks(rest);
  take(rest, openers);
  return any && beginsWithUnit(rest);
}

}  // namespace

std::optional<PrintedFactor> printedFactorIn(std::string_view title) {
  for (std::size_t at = 0; at < title.size(); ++at) {
    std::string_view rest = title.substr(at);
    const bool afterSign = takeSign(title, at, rest);
    const int words = !afterSign && mayBeginNumber(title, at) ? wordsUpToQuantity(title.substr(0, at)) : 0;
    const bool afterName = words > 0;
    if (!afterSign && !afterName && !takePlace(title, rest)) continue;
    const std::size_t from = afterSign ? at : title.size() - rest.size();
    takeBlanks(rest);
    const std::string_view number = rest;
    std::optional<double> factor = takePower(rest, afterSign);
    bool unread = false;
    if (afterSign) {
      std::string_view beyond = rest;
      if (!factor) take(beyond, "10");  // digits that are no exponent behind it: "x1072N"
      unread = beyond.size() < number.size() && takeUnread(beyond);
      if (unread) factor.reset(), rest = beyond;
    }
    if (!factor && !unread) continue;
    const std::string_view behind = rest;
    takeBlanks(rest);
    const bool inBrackets = afterName && take(rest, openers) < openers.size();
    if (words > 1 && !inBrackets) continue;  // "operating force: 100 gf" is the value of a point
    if (!afterSign && !beginsWithUnit(rest)) continue;
    if (afterName && rest.find(' ') != std::string_view::npos) continue;
    PrintedFactor found{factor, std::string(title.substr(0, from)) + std::string(behind)};
    return std::ranges::any_of(found.title, isUnitLetter) ? std::optional(std::move(found)) : std::nullopt;
  }
  return {};
}

}  // namespace detent::importer
