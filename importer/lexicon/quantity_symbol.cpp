// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/quantity_symbol.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "importer/lexicon/letters.h"
#include "model/units.h"

namespace detent::importer {
namespace {

/// The first sign of a text, which is not empty.
std::string_view firstSign(std::string_view text) {
  std::size_t bytes = 1;
  while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) ++bytes;
  return text.substr(0, bytes);
}

char32_t codeOf(std::string_view sign) { return codePoints(sign).front(); }

bool isSymbolLetter(char32_t c) {
  constexpr char32_t micro = 0xB5, firstGreek = 0x370, lastGreek = 0x3FF;
  return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || c == micro ||
         (c >= firstGreek && c <= lastGreek);
}

bool isDigit(char32_t c) { return c >= U'0' && c <= U'9'; }

/// Returns true for what may stand for a letter: documents whose fonts name their letters wrongly make other
/// signs of Greek ones, and engines a euro of an epsilon. Other signs and digits may be read of an ideograph.
bool mayBeSymbol(char32_t c, TextSource source) {
  constexpr char32_t firstLatinSign = 0xA1, lastLatinSign = 0xBF, euro = 0x20AC;
  const bool isLatinSign = c >= firstLatinSign && c <= lastLatinSign;
  return isSymbolLetter(c) || (source == TextSource::exact ? isLatinSign : c == euro);
}

bool takeOff(std::string_view& text, std::string_view front) {
  if (!text.starts_with(front)) return false;
  text.remove_prefix(front.size());
  return true;
}

template <class Test>
void takeOffWhile(std::string_view& text, Test test) {
  while (!text.empty() && test(codeOf(firstSign(text)))) text.remove_prefix(firstSign(text).size());
}

/// Takes off "_{max}", "z", "₁".
void takeOffIndex(std::string_view& text) {
  constexpr std::array<std::string_view, 8> indices{"max", "min", "rms", "x", "y", "z", "n", "N"};
  const auto isIndexDigit = [](char32_t c) { return isDigit(c) || (c >= 0x2080 && c <= 0x209C); };
  const auto isOfIndex = [&](char32_t c) { return isSymbolLetter(c) || isIndexDigit(c); };
  if (!text.empty() && isIndexDigit(codeOf(firstSign(text)))) text.remove_prefix(firstSign(text).size());
  if (takeOff(text, "_")) {
    takeOff(text, "{");
    takeOffWhile(text, isOfIndex);
    takeOff(text, "}");
    return;
  }
  for (const std::string_view index : indices) {
    std::string_view rest = text;
    if (!takeOff(rest, index) || (!rest.empty() && isOfIndex(codeOf(firstSign(rest))))) continue;
    text = rest;
    return;
  }
}

/// Takes off the argument of a function, "(t)", where more stands behind it.
void takeOffArgument(std::string_view& text) {
  if (text.size() > 3 && text[0] == '(' && text[2] == ')' &&
      isSymbolLetter(static_cast<unsigned char>(text[1])))
    text.remove_prefix(3);
}

/// Without the sign of a difference or of an amount, as printed or as an engine reads it: "Δa", "Aa", "lal".
std::string_view withoutDifference(std::string_view title, TextSource source) {
  for (const std::string_view difference : {"\xCE\x94", "\xE2\x88\x86", "A"}) {
    std::string_view rest = title;
    if ((difference == "A" && source == TextSource::exact) || !takeOff(rest, difference)) continue;
    takeOff(rest, " ");
    return !rest.empty() && isSymbolLetter(codeOf(firstSign(rest))) ? rest : title;
  }
  return title;
}

std::string withoutAmount(std::string_view title) {
  constexpr std::string_view strokes = "|lI1";
  const bool isAmount = title.size() > 3 && title[0] == title[2] &&
                        strokes.find(title[0]) != std::string_view::npos &&
                        isSymbolLetter(static_cast<unsigned char>(title[1]));
  return isAmount ? title[1] + std::string(title.substr(3)) : std::string(title);
}

/// The quantity of a unit of force or length with the signs around it; `none` of anything else.
Quantity measuredIn(std::string_view unit) {
  constexpr std::string_view around = " \t[](){}<>|/,.:;";
  const auto first = unit.find_first_not_of(around), last = unit.find_last_not_of(around);
  if (first == std::string_view::npos) return Quantity::none;
  std::string symbol(unit.substr(first, last - first + 1));
  if (const auto reading = unitReadAs(symbol, TextSource::recognised, false);
      reading && !reading->needsQuantity)
    symbol = reading->printed;
  return forceUnitFrom(symbol) ? Quantity::force : lengthUnitFrom(symbol) ? Quantity::travel : Quantity::none;
}

bool isSymbolOf(std::string_view symbol, std::string_view quantity) {
  return std::ranges::any_of(entriesOf(WordKind::symbol), [&](const LexiconEntry& entry) {
    return entry.word == symbol && entry.value == quantity;
  });
}

}  // namespace

std::optional<QuantitySymbol> symbolBeforeUnit(std::string_view title, TextSource source) {
  const auto isAround = [](char32_t c) { return c == U' ' || c == U'$' || c == U'|' || c == U'\\'; };
  const std::string plain = source == TextSource::recognised ? withoutAmount(title) : std::string(title);
  std::string_view rest = plain;
  takeOffWhile(rest, isAround);
  rest = withoutDifference(rest, source);
  if (rest.empty() || !mayBeSymbol(codeOf(firstSign(rest)), source)) return {};
  const std::string_view symbol = firstSign(rest);
  rest.remove_prefix(symbol.size());
  takeOffIndex(rest);
  takeOffArgument(rest);
  takeOffWhile(rest, isAround);
  constexpr std::string_view announcesUnit = "[({<,./:;";
  const bool isAnnounced = !rest.empty() && announcesUnit.find(rest.front()) != std::string_view::npos;
  if (!isAnnounced && !takeOff(rest, "in ")) return {};
  const Quantity measured = measuredIn(rest);
  if (measured == Quantity::none) return {};
  const std::string_view quantity = measured == Quantity::force ? "force" : "travel";
  return QuantitySymbol{std::string(symbol), isSymbolOf(symbol, quantity)};
}

}  // namespace detent::importer
