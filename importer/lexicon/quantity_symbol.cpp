// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/quantity_symbol.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "importer/lexicon/letters.h"

namespace detent::importer {
namespace {

/// A letter that a title begins with, and whether a difference is meant: "Δl".
struct Symbol {
  std::u32string_view letter;
  bool isDifference = false;
};

bool isSymbolLetter(char32_t c) {
  return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || c == 0xB5 || (c >= 0x370 && c <= 0x3FF);
}

bool isDigitOrIndex(char32_t c) {
  return (c >= U'0' && c <= U'9') || (c >= 0x2080 && c <= 0x209C);  // subscripts
}

/// Takes this text off the front; returns true if it stood there.
bool takeOff(std::u32string_view& text, std::u32string_view front) {
  if (!text.starts_with(front)) return false;
  text.remove_prefix(front.size());
  return true;
}

template <class Test>
void takeOffWhile(std::u32string_view& text, Test test) {
  while (!text.empty() && test(text.front())) text.remove_prefix(1);
}

/// The directions and the extremes that symbols carry as an index.
constexpr std::array<std::u32string_view, 8> kIndices{U"max", U"min", U"rms", U"x", U"y", U"z", U"n", U"N"};

/// Takes off "_{max}", "z", "₁".
void takeOffIndex(std::u32string_view& text) {
  const auto isLetterOrDigit = [](char32_t c) { return isSymbolLetter(c) || isDigitOrIndex(c); };
  takeOffWhile(text, isDigitOrIndex);
  if (takeOff(text, U"_")) {
    takeOff(text, U"{");
    takeOffWhile(text, isLetterOrDigit);
    takeOff(text, U"}");
    return;
  }
  for (const std::u32string_view index : kIndices) {
    std::u32string_view rest = text;
    takeOff(rest, U" ");
    if (!takeOff(rest, index) || (!rest.empty() && isLetterOrDigit(rest.front()))) continue;
    text = rest;
    return;
  }
}

/// Takes off the argument of a function, "(t)", where more than it stands there.
void takeOffArgument(std::u32string_view& text) {
  if (text.size() > 3 && text[0] == U'(' && text[2] == U')' && isSymbolLetter(text[1])) text.remove_prefix(3);
}

std::optional<Symbol> symbolAtStart(std::u32string_view title) {
  const auto isAround = [](char32_t c) { return c == U' ' || c == U'$' || c == U'|' || c == U'\\'; };
  takeOffWhile(title, isAround);
  const bool isDifference = title.size() > 1 && (title[0] == 0x394 || title[0] == 0x2206) &&
                            (isSymbolLetter(title[1]) || (title[1] == U' ' && title.size() > 2));
  if (isDifference) takeOffWhile(title, [](char32_t c) { return c == 0x394 || c == 0x2206 || c == U' '; });
  if (title.empty() || !isSymbolLetter(title.front())) return {};
  const Symbol symbol{title.substr(0, 1), isDifference};
  title.remove_prefix(1);
  takeOffIndex(title);
  takeOffArgument(title);
  takeOffWhile(title, isAround);
  constexpr std::u32string_view announcesUnit = U"[({<,./:;";
  const bool isBeforeUnit =
      !title.empty() &&
      (announcesUnit.find(title.front()) != std::u32string_view::npos || title.starts_with(U"in "));
  return isBeforeUnit ? std::optional(symbol) : std::nullopt;
}

/// Quantities of the lexicon's symbols that fit.
template <class Fits>
std::vector<std::string_view> quantitiesWhere(Fits fits) {
  std::vector<std::string_view> found;
  for (const LexiconEntry& entry : entriesOf(WordKind::symbol))
    if (fits(entry.word) && std::ranges::find(found, entry.value) == found.end()) found.push_back(entry.value);
  return found;
}

}  // namespace

std::vector<std::string_view> quantitiesOfSymbol(std::string_view title, std::string_view wanted,
                                                 TextSource source) {
  constexpr double likeliest = 0.5;  // cost of one letter that the engine confuses
  const std::u32string letters = codePoints(title);
  const std::optional<Symbol> symbol = symbolAtStart(letters);
  if (!symbol) return {};
  const auto isIt = [&](std::string_view word) { return codePoints(word) == symbol->letter; };
  const auto names = [](const std::vector<std::string_view>& quantities, std::string_view quantity) {
    return std::ranges::find(quantities, quantity) != quantities.end();
  };
  std::vector<std::string_view> found = quantitiesWhere(isIt);
  if (source == TextSource::recognised && !found.empty()) {
    const auto same = std::ranges::find_if(entriesOf(WordKind::symbol),
                                           [&](const LexiconEntry& entry) { return isIt(entry.word); });
    const std::string read = folded(same->word);
    found = quantitiesWhere([&](std::string_view word) { return folded(word) == read; });
    const auto mayBeMisread = [&](std::string_view word) {
      return costOfReading(read, folded(word), likeliest, true).has_value();
    };
    if (!names(found, wanted) && names(quantitiesWhere(mayBeMisread), wanted)) return {};
  }
  // The difference of two lengths is a travel.
  if (symbol->isDifference && names(found, "length")) found.insert(found.begin(), "travel");
  return found;
}

}  // namespace detent::importer
