// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/quantity_symbol.h"

#include <algorithm>
#include <array>

#include "importer/lexicon/letters.h"
#include "model/units.h"

namespace detent::importer {
namespace {

/// The plain letter for a mathematical italic or bold one, in which documents set formulas: a for "𝑎 [g]".
/// Any other letter unchanged.
char32_t withoutMathematicalStyle(char32_t c) {
  constexpr char32_t firstLatin = 0x1D400, lastLatin = 0x1D6A3, firstGreek = 0x1D6A8, lastGreek = 0x1D7C9,
                     planck = 0x210E;
  constexpr char32_t capitals = 26, lettersOfLatin = 52, lettersOfGreek = 58;  // of one style
  constexpr std::u32string_view greek = U"ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΘΣΤΥΦΧΨΩ∇αβγδεζηθικλμνξοπρςστυφχψω∂ϵϑϰϕϱϖ";
  static_assert(greek.size() == lettersOfGreek);
  if (c == planck) return U'h';
  if (c >= firstGreek && c <= lastGreek) return greek[(c - firstGreek) % lettersOfGreek];
  if (c < firstLatin || c > lastLatin) return c;
  const char32_t letter = (c - firstLatin) % lettersOfLatin;
  return letter < capitals ? U'A' + letter : U'a' + (letter - capitals);
}

bool isSymbolLetter(char32_t c) {
  constexpr char32_t micro = 0xB5, firstGreek = 0x370, lastGreek = 0x3FF;
  return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || c == micro ||
         (c >= firstGreek && c <= lastGreek);
}

bool isIndexDigit(char32_t c) { return (c >= U'0' && c <= U'9') || (c >= U'₀' && c <= U'ₜ'); }

/// Returns true if a character may stand for a letter. Documents whose fonts name letters wrongly have other
/// signs for Greek letters, and text engines read an epsilon as a euro sign. Other signs and digits are
/// excluded, because they may be misread ideographs.
bool mayBeSymbol(char32_t c, TextSource source) {
  const bool isLatinSign = c >= U'¡' && c <= U'¿';
  return isSymbolLetter(c) || (source == TextSource::exact ? isLatinSign : c == U'€');
}

bool takeOff(std::u32string_view& text, std::u32string_view front) {
  if (!text.starts_with(front)) return false;
  text.remove_prefix(front.size());
  return true;
}

template <class Test>
void takeOffWhile(std::u32string_view& text, Test test) {
  while (!text.empty() && test(text.front())) text.remove_prefix(1);
}

/// Removes an index: "_{max}", "z", "₁".
void takeOffIndex(std::u32string_view& text) {
  constexpr std::array<std::u32string_view, 8> indices{U"max", U"min", U"rms", U"x", U"y", U"z", U"n", U"N"};
  const auto isOfIndex = [](char32_t c) { return isSymbolLetter(c) || isIndexDigit(c); };
  if (!text.empty() && isIndexDigit(text.front())) text.remove_prefix(1);
  if (takeOff(text, U"_")) {
    takeOff(text, U"{");
    takeOffWhile(text, isOfIndex);
    takeOff(text, U"}");
    return;
  }
  for (const std::u32string_view index : indices) {
    std::u32string_view rest = text;
    if (!takeOff(rest, index) || (!rest.empty() && isOfIndex(rest.front()))) continue;
    text = rest;
    return;
  }
}

/// Removes the argument of a function, "(t)", if more text follows it.
void takeOffArgument(std::u32string_view& text) {
  if (text.size() > 3 && text[0] == U'(' && text[2] == U')' && isSymbolLetter(text[1])) text.remove_prefix(3);
}

/// Removes the sign of a difference in front of a letter, as printed ("Δa") or as an engine reads it ("Aa").
void takeOffDifference(std::u32string_view& title, TextSource source) {
  for (const std::u32string_view difference : {U"Δ", U"∆", U"A"}) {
    std::u32string_view rest = title;
    if ((difference == U"A" && source == TextSource::exact) || !takeOff(rest, difference)) continue;
    takeOff(rest, U" ");
    if (!rest.empty() && isSymbolLetter(rest.front())) title = rest;
    return;
  }
}

/// The title without the bars of an absolute value, which an engine reads as letters: "lal".
std::u32string withoutAmount(const std::u32string& title) {
  constexpr std::u32string_view strokes = U"|lI1";
  const bool isAmount = title.size() > 3 && title[0] == title[2] &&
                        strokes.find(title[0]) != std::u32string_view::npos && isSymbolLetter(title[1]);
  return isAmount ? title[1] + title.substr(3) : title;
}

/// The quantity of a unit of force or length, ignoring brackets and punctuation around it; `none` for
/// anything else.
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
  std::u32string letters = codePoints(title);
  std::ranges::transform(letters, letters.begin(), withoutMathematicalStyle);
  if (source == TextSource::recognised) letters = withoutAmount(letters);
  std::u32string_view rest = letters;
  takeOffWhile(rest, isAround);
  takeOffDifference(rest, source);
  if (rest.empty() || !mayBeSymbol(rest.front(), source)) return {};
  const std::string symbol = utf8Of(rest.substr(0, 1));
  rest.remove_prefix(1);
  takeOffIndex(rest);
  takeOffArgument(rest);
  takeOffWhile(rest, isAround);
  constexpr std::u32string_view announcesUnit = U"[({<,./:;";
  const bool isAnnounced = !rest.empty() && announcesUnit.find(rest.front()) != std::u32string_view::npos;
  if (!isAnnounced && !takeOff(rest, U"in ")) return {};
  const Quantity measured = measuredIn(utf8Of(rest));
  if (measured == Quantity::none) return {};
  return QuantitySymbol{symbol, isSymbolOf(symbol, measured == Quantity::force ? "force" : "travel")};
}

}  // namespace detent::importer
